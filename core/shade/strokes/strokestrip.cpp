// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/strokes/strokestrip.h"

#include "core/number/wideinteger.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// ⌊√square⌋ for square < 2^52.
std::int64_t rootOf(std::int64_t square) { return std::int64_t(std::sqrt(double(square))); }

/// The nearest integer to 2^15·part/√(dx² + dy²), halves away from 0.
template <class Wide>
StrokeUnit halfShare(const Wide &part, const Wide &squares)
{
    // ⌊2·quotient⌋, which decides halves.
    const auto doubled = rootOf(std::int64_t(Wide((part * part << 32) / squares)));
    const StrokeUnit nearest = (doubled + 1) / 2;
    return part < 0 ? -nearest : nearest;
}

template <class Wide>
StrokePoint halfWidth(const Wide &dx, const Wide &dy)
{
    const Wide squares = dx * dx + dy * dy;
    return {-halfShare<Wide>(dy, squares), halfShare<Wide>(dx, squares)};
}

/// The nearest integer, halves up; the denominator is positive.
StrokeUnit nearestQuotient(Int128 numerator, Int128 denominator)
{
    return StrokeUnit(floorDivide<Int128>(2 * numerator + denominator, 2 * denominator));
}

StrokePoint onStrokes(const LatticePoint &point)
{
    return {point.x * strokeUnitsPerLattice, point.y * strokeUnitsPerLattice};
}

/// Collects the quadrilaterals near the squares of the frame's pixels.
class StripCollector {
public:
    explicit StripCollector(const FrameView &frame)
        : m_first{frame.firstColumn * strokeUnitsPerPixel - strokeHalfPixel,
                  frame.firstRow * strokeUnitsPerPixel - strokeHalfPixel}
        , m_end{frame.endColumn() * strokeUnitsPerPixel - strokeHalfPixel,
                frame.endRow() * strokeUnitsPerPixel - strokeHalfPixel}
    {
    }

    /// Whether anything within `reach` of the box of two points can come near.
    bool mayMeet(const StrokePoint &a, const StrokePoint &b, StrokeUnit reach) const
    {
        return std::max(a.x, b.x) + reach >= m_first.x && std::min(a.x, b.x) - reach <= m_end.x
            && std::max(a.y, b.y) + reach >= m_first.y && std::min(a.y, b.y) - reach <= m_end.y;
    }
    void add(const StrokeJoint &from, const StrokeJoint &to)
    {
        if (mayMeet(from.at, to.at, strokeUnitsPerPixel))
            quads.push_back({from.right(), to.right(), to.left(), from.left()});
    }

    std::vector<StrokeQuad> quads;

private:
    StrokePoint m_first, m_end; ///< of the squares
};

/// Collects joints first … end of a part of a curve, whose joints are k = 0 … pieces(). reach()
/// says how far the curve strays from the box around the ends of a run of joints.
template <class Curve>
void collect(const Curve &curve, int part, std::int64_t first, std::int64_t end,
             StripCollector &collector)
{
    const StrokeJoint from = curve.joint(part, first);
    const StrokeJoint to = curve.joint(part, end);
    if (end - first == 1) {
        collector.add(from, to);
        return;
    }
    if (!collector.mayMeet(from.at, to.at, curve.reach(end - first) + strokeUnitsPerPixel))
        return;
    const std::int64_t middle = first + (end - first) / 2;
    collect(curve, part, first, middle, collector);
    collect(curve, part, middle, end, collector);
}

/// A quarter turn is ((1 − t²)/(1 + t²), 2t/(1 + t²)) for t = k/2^m, which is rational; the other
/// three are its mirror images. Between two points the angle grows by at most 2·2^-m, and the arc
/// of radius r is at most r·2^-2m/2 from its chord.
class EllipseCurve {
public:
    static constexpr int parts = 4;

    explicit EllipseCurve(const Shape &shape)
        : m_centre(onStrokes(shape.vertices[0].position))
        , m_radiusX(absolute(shape.vertices[1].position.x - shape.vertices[0].position.x))
        , m_radiusY(absolute(shape.vertices[1].position.y - shape.vertices[0].position.y))
    {
        // Includes the outer side of a circle.
        const Lattice outer = std::max(m_radiusX, m_radiusY) + halfPixel;
        while (outer > (Lattice(1) << (2 * m_bits - 1)))
            ++m_bits;
    }

    bool hasLength() const { return m_radiusX > 0 || m_radiusY > 0; }
    std::int64_t pieces() const { return std::int64_t(1) << m_bits; }
    /// A quarter lies in the box of its ends.
    static StrokeUnit reach(std::int64_t) { return 0; }

    StrokeJoint joint(int part, std::int64_t k) const
    {
        const bool isMirrored = part % 2 == 1;
        const Int128 at = isMirrored ? pieces() - k : k;
        const Int128 all = pieces();
        const Int128 along = all * all - at * at;
        const Int128 across = 2 * all * at;
        const Int128 whole = all * all + at * at;
        // At its right end the first quarter runs upward: the centre is to its left.
        const StrokePoint inward = strokeHalfWidth(-m_radiusX * across, m_radiusY * along);
        const int signX = part == 0 || part == 3 ? 1 : -1;
        const int signY = part < 2 ? 1 : -1;
        const auto ofQuarter = [&](StrokeUnit x, StrokeUnit y) -> StrokePoint {
            return {signX * x, signY * y};
        };
        const StrokePoint from
            = ofQuarter(nearestQuotient(along * strokeUnitsPerLattice * m_radiusX, whole),
                        nearestQuotient(across * strokeUnitsPerLattice * m_radiusY, whole));
        return {{m_centre.x + from.x, m_centre.y + from.y}, ofQuarter(inward.x, inward.y)};
    }

private:
    StrokePoint m_centre;
    Lattice m_radiusX, m_radiusY;
    int m_bits = 2; ///< m
};

/// The points P(k/2^m), exact before rounding; the direction at each is from the point before to
/// the point after it. With second differences up to D a curve of degree n is at most n·(n −
/// 1)·D·2^-2m/8 from its chords.
class BezierCurve {
public:
    static constexpr int parts = 1;

    explicit BezierCurve(const Shape &shape)
        : m_degree(int(shape.vertices.size()) - 1)
    {
        for (std::size_t i = 0; i < shape.vertices.size(); ++i)
            m_control[i] = shape.vertices[i].position;
        for (std::size_t i = 0; i + 2 < shape.vertices.size(); ++i) {
            const auto second = [&](Lattice LatticePoint::*axis) {
                return absolute(m_control[i].*axis - 2 * m_control[i + 1].*axis
                                + m_control[i + 2].*axis);
            };
            m_bend = std::max(m_bend, second(&LatticePoint::x) + second(&LatticePoint::y));
        }
        m_bend *= Lattice(m_degree) * (m_degree - 1);
        while (m_bend > (Int128(1) << (2 * m_bits + 1)))
            ++m_bits;
    }

    bool hasLength() const
    {
        return std::any_of(m_control.begin() + 1, m_control.begin() + m_degree + 1,
                           [this](const LatticePoint &point) { return point != m_control[0]; });
    }
    std::int64_t pieces() const { return std::int64_t(1) << m_bits; }
    StrokeUnit reach(std::int64_t run) const
    {
        return StrokeUnit(Int128(m_bend) * run * run * strokeUnitsPerLattice >> (2 * m_bits + 3))
            + 1;
    }

    StrokeJoint joint(int, std::int64_t k) const
    {
        const Exact at = exactAt(k);
        const Exact before = exactAt(std::max<std::int64_t>(k - 1, 0));
        const Exact after = exactAt(std::min(k + 1, pieces()));
        const Int128 unit = Int128(1) << (m_degree * m_bits);
        return {{nearestQuotient(at.x * strokeUnitsPerLattice, unit),
                 nearestQuotient(at.y * strokeUnitsPerLattice, unit)},
                strokeHalfWidth(after.x - before.x, after.y - before.y)};
    }

private:
    /// Lattice units times 2^(n·m): at most 104 bits.
    struct Exact {
        Int128 x = 0, y = 0;
    };
    /// Bernstein's form.
    Exact exactAt(std::int64_t k) const
    {
        constexpr std::array<std::array<int, 4>, 4> binomials
            = {{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}}};
        Exact sum;
        for (int i = 0; i <= m_degree; ++i) {
            Int128 weight = binomials[std::size_t(m_degree)][std::size_t(i)];
            for (int factor = 0; factor < m_degree; ++factor)
                weight *= factor < i ? k : pieces() - k;
            sum.x += weight * m_control[std::size_t(i)].x;
            sum.y += weight * m_control[std::size_t(i)].y;
        }
        return sum;
    }

    std::array<LatticePoint, 4> m_control;
    int m_degree;
    Lattice m_bend = 0; ///< the second derivative's bound, |x| + |y|, lattice units
    int m_bits = 4; ///< m
};

template <class Curve>
StrokeStrip stripOf(const Curve &curve, const FrameView &frame)
{
    if (!curve.hasLength())
        return {};
    StripCollector collector(frame);
    for (int part = 0; part < Curve::parts; ++part)
        collect(curve, part, 0, curve.pieces(), collector);
    return {Curve::parts * curve.pieces(), std::move(collector.quads)};
}

StrokeStrip lineStrip(const Shape &line, const FrameView &frame)
{
    const LatticePoint &a = line.vertices[0].position;
    const LatticePoint &b = line.vertices[1].position;
    if (a == b)
        return {};
    const StrokePoint half = strokeHalfWidth(b.x - a.x, b.y - a.y);
    StripCollector collector(frame);
    collector.add({onStrokes(a), half}, {onStrokes(b), half});
    return {1, std::move(collector.quads)};
}

} // namespace

StrokePoint strokeHalfWidth(Int128 dx, Int128 dy)
{
    if (dx == 0 && dy == 0)
        return {};
    // 2^32 times a square must fit.
    constexpr Int128 largestNarrow = Int128(1) << 46;
    if (absolute(dx) <= largestNarrow && absolute(dy) <= largestNarrow)
        return halfWidth<Int128>(dx, dy);
    return halfWidth<Int256>(Int256(dx), Int256(dy));
}

bool isStroke(const Shape &shape)
{
    switch (shape.kind) {
    case PrimitiveKind::Line:
        return true;
    case PrimitiveKind::Bezier:
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return shape.fill == ShapeFill::Outline;
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Text:
        break;
    }
    return false;
}

StrokeStrip strokeStripOf(const Shape &shape, const FrameView &frame)
{
    switch (shape.kind) {
    case PrimitiveKind::Line:
        return lineStrip(shape, frame);
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return stripOf(EllipseCurve(shape), frame);
    case PrimitiveKind::Bezier:
        return stripOf(BezierCurve(shape), frame);
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Text:
        break;
    }
    return {};
}

bool isShort(const Shape &stroke)
{
    const LatticePoint &from = stroke.vertices.front().position;
    return std::ranges::all_of(stroke.vertices, [&from](const Vertex &vertex) {
        return absolute(vertex.position.x - from.x) < unitsPerPixel
            && absolute(vertex.position.y - from.y) < unitsPerPixel;
    });
}

} // namespace pixelplumb
