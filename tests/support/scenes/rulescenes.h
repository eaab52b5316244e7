// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "tests/support/framespec.h"
#include "tests/support/scenes/trianglepictures.h"

#include <random>
#include <vector>

/// What the fill-rule tests draw, and into which frames.
namespace pixelplumb {

/// Frames that differ in everything a rule may depend on.
inline std::vector<FrameSpec> frames()
{
    std::vector<FrameSpec> found;
    for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft}) {
        for (const PixelCentre centre : {PixelCentre::Integer, PixelCentre::Half}) {
            for (const std::int32_t first : {0, -5}) {
                FrameSpec spec = frameOf(17, 11, first, 2 * first);
                spec.origin = origin;
                spec.pixelCentre = centre;
                found.push_back(spec);
                spec.offScreenPoint = {20 * unitsPerPixel + 77, -3 * unitsPerPixel};
                found.push_back(spec);
            }
        }
    }
    return found;
}

/// Random vertices. On lattices of whole and half pixels most boundary samples lie on an edge or a
/// vertex.
class VertexSource {
public:
    VertexSource(const FrameSpec &frame, Lattice step, std::uint64_t seed)
        : m_frame(frame)
        , m_step(step)
        , m_random(seed)
    {
    }

    Triangle next() { return triangleOf({point(), point(), point()}); }

    /// A triangle without area: its vertices lie on one line or coincide.
    Triangle nextFlat()
    {
        const LatticePoint a = point();
        const LatticePoint b = point();
        const Lattice part = std::uniform_int_distribution<Lattice>(0, 2)(m_random);
        return triangleOf({a, b, {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}});
    }

    /// A random polygon, which may intersect itself.
    Shape nextPolygon(int vertices)
    {
        Shape polygon;
        polygon.kind = PrimitiveKind::Polygon;
        polygon.fill = ShapeFill::EvenOdd;
        for (int i = 0; i < vertices; ++i)
            polygon.vertices.push_back({point(), {{1, 2, 3}}});
        return polygon;
    }

private:
    LatticePoint point()
    {
        return {coordinate(m_frame.firstColumn, m_frame.width),
                coordinate(m_frame.firstRow, m_frame.height)};
    }
    /// A coordinate from 2 px before the frame to 2 px after it.
    Lattice coordinate(std::int32_t first, std::int32_t count)
    {
        const Lattice steps = (count + 4) * unitsPerPixel / m_step;
        return (first - 2) * unitsPerPixel
            + std::uniform_int_distribution<Lattice>(0, steps)(m_random) * m_step;
    }

    FrameSpec m_frame;
    Lattice m_step; ///< lattice units
    std::mt19937_64 m_random;
};

/// The methods that decide by samples, not by pixels near an outline.
inline std::vector<const Method *> methodsOfTriangles()
{
    std::vector<const Method *> found;
    for (const Method &method : methods()) {
        if (method.draws(PrimitiveKind::Triangle) && method.isStableIn(Arithmetic::Exact))
            found.push_back(&method);
    }
    return found;
}

} // namespace pixelplumb
