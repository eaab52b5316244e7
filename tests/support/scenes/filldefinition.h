// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <algorithm>
#include <array>

/// The fill rules taken literally from their definition, sample by sample: displace a sample by a
/// vector of powers of an infinitely small ε and test whether it then lies strictly inside. The
/// edge function of the displaced sample is a polynomial in ε, whose sign is that of its first
/// non-zero coefficient. Everything is in integers of 1/256 px; nothing but the vertex type is
/// shared with the kernels or the oracle.
namespace pixelplumb::definition {

/// c₀ + c₁·ε + c₂·ε².
using Polynomial = std::array<std::int64_t, 3>;

inline int signOf(const Polynomial &polynomial)
{
    for (const std::int64_t coefficient : polynomial) {
        if (coefficient != 0)
            return coefficient < 0 ? -1 : 1;
    }
    return 0;
}

/// The off-screen point, in the scene's coordinates.
inline LatticePoint pointOf(const FrameSpec &frame)
{
    if (frame.offScreenPoint)
        return *frame.offScreenPoint;
    return {(frame.firstColumn - 1) * 256, (frame.firstRow - 1) * 256};
}

struct DisplacedSample {
    Polynomial x, y;
};

inline DisplacedSample displaced(const LatticePoint &sample, const Scene &scene)
{
    const std::int64_t down = scene.frame.origin == FrameOrigin::TopLeft ? 1 : -1;
    const LatticePoint point = pointOf(scene.frame);
    switch (scene.settings.fillRule) {
    case FillRule::Closed:
    case FillRule::Open:
        break;
    case FillRule::HalfOpenColumn:
        return {{sample.x, 0, 1}, {sample.y, 1, 0}};
    case FillRule::TopLeft:
        return {{sample.x, 1, 0}, {sample.y, 0, down}};
    case FillRule::OffScreenPoint:
        return {{sample.x, point.x - sample.x, 0}, {sample.y, point.y - sample.y, 0}};
    }
    return {{sample.x, 0, 0}, {sample.y, 0, 0}};
}

/// (q − p) × (sample − p): twice the signed area of the triangle (p, q, sample).
inline Polynomial edgeFunction(const LatticePoint &p, const LatticePoint &q,
                               const DisplacedSample &sample)
{
    Polynomial value;
    for (std::size_t power = 0; power < 3; ++power) {
        const std::int64_t x = sample.x[power] - (power == 0 ? p.x : 0);
        const std::int64_t y = sample.y[power] - (power == 0 ? p.y : 0);
        value[power] = (q.x - p.x) * y - (q.y - p.y) * x;
    }
    return value;
}

inline bool liesBetween(std::int64_t value, std::int64_t a, std::int64_t b, std::int64_t c)
{
    return value >= std::min({a, b, c}) && value <= std::max({a, b, c});
}

inline bool isInside(const Triangle &triangle, std::int64_t column, std::int64_t row,
                     const Scene &scene)
{
    const auto &[a, b, c] = triangle.vertices;
    const Lattice centre = scene.frame.pixelCentre == PixelCentre::Half ? 128 : 0;
    const LatticePoint sample = {column * 256 + centre, row * 256 + centre};
    const DisplacedSample moved = displaced(sample, scene);
    const int turn = signOf(
        edgeFunction(a.position, b.position, {{c.position.x, 0, 0}, {c.position.y, 0, 0}}));
    const std::array<int, 3> signs = {signOf(edgeFunction(a.position, b.position, moved)),
                                      signOf(edgeFunction(b.position, c.position, moved)),
                                      signOf(edgeFunction(c.position, a.position, moved))};
    const bool isClosed = scene.settings.fillRule == FillRule::Closed;
    if (turn == 0) {
        return isClosed && signs == std::array<int, 3>{}
        && liesBetween(sample.x, a.position.x, b.position.x, c.position.x)
            && liesBetween(sample.y, a.position.y, b.position.y, c.position.y);
    }
    return std::ranges::all_of(signs,
                               [&](int sign) { return sign == turn || (isClosed && sign == 0); });
}

/// A displaced sample is inside an even-odd polygon if it lies in an odd number of the triangles
/// formed by the first vertex and the edges.
inline bool isInside(const Shape &polygon, std::int64_t column, std::int64_t row,
                     const Scene &scene)
{
    const auto &vertices = polygon.vertices;
    bool isOdd = false;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        isOdd ^= isInside(Triangle{{{vertices[0], vertices[i], vertices[i + 1]}}}, column, row,
                          scene);
    return isOdd;
}

} // namespace pixelplumb::definition
