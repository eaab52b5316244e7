// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/strokeoutline.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

struct OutlineExact {
    BigRational x, y; ///< 2^-16 px
};

/// A point of the curve, and the offset of ½ px to its left.
struct SideJoint {
    OutlinePoint at, half;

    OutlinePoint left() const { return {at.x + half.x, at.y + half.y}; }
    OutlinePoint right() const { return {at.x - half.x, at.y - half.y}; }
};

BigInteger roundedDown(const BigRational &value)
{
    const BigInteger quotient = numerator(value) / denominator(value);
    return numerator(value) < quotient * denominator(value) ? BigInteger(quotient - 1) : quotient;
}

std::int64_t nearestUnit(const BigRational &value)
{
    return std::int64_t(roundedDown(value + BigRational(1, 2)));
}

/// The largest n with n − ½ <= 2^15·|part|/√squares, by bisection, with the sign of `part`.
std::int64_t halfPartOf(const BigRational &part, const BigRational &squares)
{
    std::int64_t low = 0;
    std::int64_t high = halfSquare + 1;
    while (high - low > 1) {
        const std::int64_t middle = (low + high) / 2;
        const BigInteger odd = 2 * middle - 1;
        const bool isAtMost
            = BigRational(odd * odd) * squares <= part * part * outlinePixel * outlinePixel;
        (isAtMost ? low : high) = middle;
    }
    return part < 0 ? -low : low;
}

OutlinePoint sideOf(const BigRational &dx, const BigRational &dy)
{
    const BigRational squares = dx * dx + dy * dy;
    if (squares == 0)
        return {};
    return {halfPartOf(-dy, squares), halfPartOf(dx, squares)};
}

OutlineExact onOutlines(const LatticePoint &point)
{
    return {BigRational(point.x * outlineLattice), BigRational(point.y * outlineLattice)};
}

/// The largest distance of a chord from its curve.
BigRational allowedSagitta() { return BigRational(outlinePixel, 1024); }

/// An ellipse by quarters, counterclockwise from the right end, each the mirror image of its
/// neighbour: t = k/2^m.
class EllipseSides {
public:
    static constexpr int parts = 4;

    explicit EllipseSides(const Shape &shape)
        : m_centre(onOutlines(shape.vertices[0].position))
    {
        const OutlineExact corner = onOutlines(shape.vertices[1].position);
        m_radiusX = abs(corner.x - m_centre.x);
        m_radiusY = abs(corner.y - m_centre.y);
        const BigRational outer = std::max(m_radiusX, m_radiusY) + halfSquare;
        for (m_pieces = 4; outer / (2 * BigInteger(m_pieces) * m_pieces) > allowedSagitta();)
            m_pieces *= 2;
    }

    bool isPoint() const { return m_radiusX == 0 && m_radiusY == 0; }
    static bool isClosed() { return true; }
    std::int64_t pieces() const { return m_pieces; }
    static std::int64_t strays(std::int64_t) { return 0; }

    SideJoint joint(int part, std::int64_t k) const
    {
        const bool isEven = part % 2 == 0;
        const BigRational t(isEven ? k : m_pieces - k, m_pieces);
        const BigRational cosine = (1 - t * t) / (1 + t * t);
        const BigRational sine = 2 * t / (1 + t * t);
        const std::int64_t right = part == 0 || part == 3 ? 1 : -1;
        const std::int64_t up = part < 2 ? 1 : -1;
        const OutlinePoint inside = sideOf(-m_radiusX * sine, m_radiusY * cosine);
        return {{nearestUnit(m_centre.x) + right * nearestUnit(m_radiusX * cosine),
                 nearestUnit(m_centre.y) + up * nearestUnit(m_radiusY * sine)},
                {right * inside.x, up * inside.y}};
    }

private:
    OutlineExact m_centre;
    BigRational m_radiusX, m_radiusY;
    std::int64_t m_pieces = 0;
};

class BezierSides {
public:
    static constexpr int parts = 1;

    explicit BezierSides(const Shape &shape)
    {
        for (const Vertex &vertex : shape.vertices)
            m_control.push_back(onOutlines(vertex.position));
        for (std::size_t i = 2; i < m_control.size(); ++i) {
            const BigRational bend
                = abs(m_control[i].x - 2 * m_control[i - 1].x + m_control[i - 2].x)
                + abs(m_control[i].y - 2 * m_control[i - 1].y + m_control[i - 2].y);
            m_bend = std::max(m_bend, bend);
        }
        const BigInteger degree = m_control.size() - 1;
        m_bend *= BigRational(degree * (degree - 1), 8);
        for (m_pieces = 16; m_bend / (BigInteger(m_pieces) * m_pieces) > allowedSagitta();)
            m_pieces *= 2;
    }

    bool isPoint() const
    {
        return std::ranges::all_of(m_control, [this](const OutlineExact &point) {
            return point.x == m_control[0].x && point.y == m_control[0].y;
        });
    }
    static bool isClosed() { return false; }
    std::int64_t pieces() const { return m_pieces; }
    std::int64_t strays(std::int64_t run) const
    {
        const BigRational part(run, m_pieces);
        return nearestUnit(m_bend * part * part) + 1;
    }

    SideJoint joint(int, std::int64_t k) const
    {
        const OutlineExact at = pointAt(k);
        const OutlineExact before = pointAt(std::max<std::int64_t>(0, k - 1));
        const OutlineExact after = pointAt(std::min(m_pieces, k + 1));
        return {{nearestUnit(at.x), nearestUnit(at.y)},
                sideOf(after.x - before.x, after.y - before.y)};
    }

private:
    /// Repeated averages.
    OutlineExact pointAt(std::int64_t k) const
    {
        const BigRational t(k, m_pieces);
        std::vector<OutlineExact> points = m_control;
        for (; points.size() > 1; points.pop_back()) {
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                points[i].x += t * (points[i + 1].x - points[i].x);
                points[i].y += t * (points[i + 1].y - points[i].y);
            }
        }
        return points.front();
    }

    std::vector<OutlineExact> m_control;
    BigRational m_bend = 0; ///< upper bound for the curve's distance from the chord of the whole
    std::int64_t m_pieces = 0;
};

struct OutlineWindow {
    explicit OutlineWindow(const FrameView &frame)
        : left(frame.firstColumn * outlinePixel - halfSquare)
        , right(frame.endColumn() * outlinePixel - halfSquare)
        , low(frame.firstRow * outlinePixel - halfSquare)
        , high(frame.endRow() * outlinePixel - halfSquare)
    {
    }

    /// Whether everything within a distance of the box of two points lies to one side of the
    /// window.
    bool isBeside(const OutlinePoint &a, const OutlinePoint &b, std::int64_t distance) const
    {
        return std::max(a.x, b.x) + distance < left || std::min(a.x, b.x) - distance > right
            || std::max(a.y, b.y) + distance < low || std::min(a.y, b.y) - distance > high;
    }

    std::int64_t left, right, low, high;
};

template <class Curve>
void appendSides(std::vector<OutlineEdge> &edges, const Curve &curve, const OutlineWindow &window,
                 int part, std::int64_t first, std::int64_t end)
{
    const SideJoint from = curve.joint(part, first);
    const SideJoint to = curve.joint(part, end);
    const std::int64_t run = end - first;
    if (run == 1 || window.isBeside(from.at, to.at, curve.strays(run) + outlinePixel)) {
        edges.push_back({from.right(), to.right()});
        edges.push_back({to.left(), from.left()});
        return;
    }
    appendSides(edges, curve, window, part, first, first + run / 2);
    appendSides(edges, curve, window, part, first + run / 2, end);
}

template <class Curve>
std::vector<OutlineEdge> outlineOf(const Curve &curve, const FrameView &frame)
{
    std::vector<OutlineEdge> edges;
    if (curve.isPoint())
        return edges;
    for (int part = 0; part < Curve::parts; ++part)
        appendSides(edges, curve, OutlineWindow(frame), part, 0, curve.pieces());
    if (curve.isClosed())
        return edges;
    const SideJoint start = curve.joint(0, 0);
    const SideJoint end = curve.joint(0, curve.pieces());
    edges.push_back({start.left(), start.right()});
    edges.push_back({end.right(), end.left()});
    return edges;
}

std::vector<OutlineEdge> lineOutline(const OutlineExact &a, const OutlineExact &b)
{
    if (a.x == b.x && a.y == b.y)
        return {};
    const OutlinePoint half = sideOf(b.x - a.x, b.y - a.y);
    const SideJoint start{{nearestUnit(a.x), nearestUnit(a.y)}, half};
    const SideJoint end{{nearestUnit(b.x), nearestUnit(b.y)}, half};
    return {{start.right(), end.right()},
            {end.right(), end.left()},
            {end.left(), start.left()},
            {start.left(), start.right()}};
}

} // namespace

std::vector<OutlineEdge> strokeOutline(const Shape &stroke, const FrameView &frame)
{
    switch (stroke.kind) {
    case PrimitiveKind::Line:
        return lineOutline(onOutlines(stroke.vertices[0].position),
                           onOutlines(stroke.vertices[1].position));
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return outlineOf(EllipseSides(stroke), frame);
    case PrimitiveKind::Bezier:
        return outlineOf(BezierSides(stroke), frame);
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Text:
        break;
    }
    return {};
}

} // namespace pixelplumb::oracle
