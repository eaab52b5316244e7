// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/bezierpatch.h"
#include "core/space/solidfaces.h"
#include "core/space/vertexlight.h"

#include <cmath>
#include <type_traits>

namespace pixelplumb {

/// The point at some angle on the unit circle.
template <class Number>
struct CirclePoint {
    Number cosine = Number(1);
    Number sine = Number(0);
};

/// The point at part/whole of a full turn; exact at quarter turns, so that poles and seams meet.
template <class Number>
CirclePoint<Number> circlePoint(const Number &part, const Number &whole)
{
    using std::acos;
    using std::cos;
    using std::floor;
    using std::sin;
    const Number quarters = 4 * part / whole;
    const Number first = floor(quarters);
    const Number rest = quarters - first;
    CirclePoint<Number> point;
    if (rest != 0) {
        const Number angle = rest * acos(Number(0));
        point = {cos(angle), sin(angle)};
    }
    const Number turned = first - 4 * floor(first / 4);
    if (turned == 1)
        return {-point.sine, point.cosine};
    if (turned == 2)
        return {-point.cosine, -point.sine};
    if (turned == 3)
        return {point.sine, -point.cosine};
    return point;
}

/// A vertex of a solid, in the scene's space.
template <class Number>
struct SpaceVertex {
    SpaceVector<Number> position;
    SpaceVector<Number> normal; ///< normalized, or 0: the face's own
    std::array<Number, 2> texture = {};
    Colour colour; ///< without the material's
    std::uint8_t alpha = 255;
};

/// The vertices of a solid, computed on request and always with the same result. The solid must
/// outlive it.
template <class Number>
class SolidVertices {
public:
    using Vector = SpaceVector<Number>;

    explicit SolidVertices(const Solid &solid)
        : m_solid(solid)
        , m_at(solid.at)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_turns[axis] = circlePoint(Number(solid.rotate[axis]), Number(360));
        if (solid.kind != SolidKind::Sphere || !std::is_same_v<Number, double>)
            return;
        for (int i = 0; i < solid.segments[0]; ++i)
            m_around.push_back(aroundAt(std::size_t(i)));
        for (int j = 0; j <= solid.segments[1]; ++j)
            m_down.push_back(downAt(std::size_t(j)));
    }

    SpaceVertex<Number> vertex(std::size_t index) const
    {
        switch (m_solid.kind) {
        case SolidKind::Triangle3:
        case SolidKind::Polygon3:
            return cornerVertex(m_solid.corners[index]);
        case SolidKind::Plane:
            return planeVertex(index);
        case SolidKind::Sphere:
            return sphereVertex(index);
        case SolidKind::Patch:
            return patchVertex(index);
        case SolidKind::Mesh:
            return meshVertex(m_solid.mesh->corners[index]);
        }
        return {};
    }

private:
    static SpaceVertex<Number> cornerVertex(const SolidCorner &corner)
    {
        return {Vector(corner.position), unit(Vector(corner.normal)),
                std::array<Number, 2>{Number(corner.texture[0]), Number(corner.texture[1])},
                corner.colour, corner.alpha};
    }
    SpaceVertex<Number> vertexAt(const Vector &position, const Vector &normal,
                                 const std::array<Number, 2> &texture) const
    {
        return {position, normal, texture, m_solid.colour, m_solid.alpha};
    }

    /// P0, P1, P1 + P2 − P0, P2 at (s, t) = (0, 0), (1, 0), (1, 1), (0, 1).
    SpaceVertex<Number> planeVertex(std::size_t index) const
    {
        const auto corner = [this](std::size_t i) { return Vector(m_solid.corners[i].position); };
        const Number s = index == 1 || index == 2 ? 1 : 0;
        const Number t = index >= 2 ? 1 : 0;
        if (index == 2)
            return vertexAt(corner(1) + (corner(2) - corner(0)), {}, {s, t});
        return vertexAt(corner(index == 3 ? 2 : index), {}, {s, t});
    }

    /// C + r(sin θ sin φ, cos θ, sin θ cos φ) with θ from the upper pole and φ around, from +z
    /// towards +x; u = φ/2π, at a pole that of the cell's middle, and v = 1 − θ/π.
    SpaceVertex<Number> sphereVertex(std::size_t index) const
    {
        const auto columns = std::size_t(m_solid.segments[0]);
        const auto rows = std::size_t(m_solid.segments[1]);
        const std::size_t i = index % (columns + 1);
        const std::size_t j = index / (columns + 1);
        const bool isPole = j == 0 || j == rows;
        const CirclePoint<Number> around
            = m_around.empty() ? aroundAt(i % columns) : m_around[i % columns];
        const CirclePoint<Number> down = m_down.empty() ? downAt(j) : m_down[j];
        const Vector normal(down.sine * around.sine, down.cosine, down.sine * around.cosine);
        const Number shift = isPole ? Number(1) / 2 : Number(0);
        return vertexAt(Vector(m_solid.corners[0].position) + Number(m_solid.radius) * normal,
                        normal,
                        {(Number(i) + shift) / Number(columns), Number(rows - j) / Number(rows)});
    }

    CirclePoint<Number> aroundAt(std::size_t column) const
    {
        return circlePoint(Number(column), Number(m_solid.segments[0]));
    }
    CirclePoint<Number> downAt(std::size_t row) const
    {
        return circlePoint(Number(row), Number(2 * m_solid.segments[1]));
    }

    SpaceVertex<Number> patchVertex(std::size_t index) const
    {
        const auto columns = std::size_t(m_solid.segments[0]);
        const std::size_t row = index / (columns + 1);
        const Number u = Number(index % (columns + 1)) / Number(columns);
        const Number v = Number(row) / Number(m_solid.segments[1]);
        const BezierPatch<Number> patch(m_solid);
        return vertexAt(patch.point(u, v), patch.normal(u, v), {u, v});
    }

    SpaceVertex<Number> meshVertex(const SolidCorner &corner) const
    {
        SpaceVertex<Number> vertex = cornerVertex(corner);
        vertex.position = m_at + turned(Number(m_solid.scale) * vertex.position);
        vertex.normal = turned(vertex.normal);
        vertex.colour = tinted(corner.colour, m_solid.colour);
        vertex.alpha = tinted(corner.alpha, m_solid.alpha);
        return vertex;
    }

    /// Rotates about x, then y, then z.
    Vector turned(const Vector &point) const
    {
        const auto &[x, y, z] = m_turns;
        const Vector aboutX(point.x, x.cosine * point.y - x.sine * point.z,
                            x.sine * point.y + x.cosine * point.z);
        const Vector aboutY(y.cosine * aboutX.x + y.sine * aboutX.z, aboutX.y,
                            y.cosine * aboutX.z - y.sine * aboutX.x);
        return {z.cosine * aboutY.x - z.sine * aboutY.y, z.sine * aboutY.x + z.cosine * aboutY.y,
                aboutY.z};
    }

    const Solid &m_solid;
    Vector m_at;
    std::array<CirclePoint<Number>, 3> m_turns;
    // A sphere's, by column and by row; empty unless computed in double.
    std::vector<CirclePoint<Number>> m_around;
    std::vector<CirclePoint<Number>> m_down;
};

} // namespace pixelplumb
