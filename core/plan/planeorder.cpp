// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/planeorder.h"

#include "core/number/wideinteger.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The edge functions of one triangle at the vertices of another, positive inside: [edge][vertex],
/// edges from vertex k to k + 1. Integer is std::int64_t up to 2^15 px and Int128 beyond.
template <class Integer>
class EdgesAtVertices {
public:
    using PerVertex = std::array<Integer, 3>;

    EdgesAtVertices(const Triangle &of, const Triangle &at)
    {
        const Integer signedArea = function(of, 0, of.vertices[2].position);
        const Integer sign = signedArea < 0 ? -1 : 1;
        m_area = signedArea * sign;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            for (std::size_t vertex = 0; vertex < 3; ++vertex)
                m_values[edge][vertex] = sign * function(of, edge, at.vertices[vertex].position);
        }
    }

    const Integer &at(std::size_t edge, std::size_t vertex) const { return m_values[edge][vertex]; }
    bool isInside(std::size_t vertex) const
    {
        return at(0, vertex) >= 0 && at(1, vertex) >= 0 && at(2, vertex) >= 0;
    }
    /// How far the other triangle reaches to the inner side of the edge where it reaches least:
    /// negative where that edge separates the two, 0 where they touch it from outside. Two disjoint
    /// convex figures are separated by an edge of one of them.
    Integer parting() const
    {
        const auto most = [](const PerVertex &values) { return std::ranges::max(values); };
        return std::min({most(m_values[0]), most(m_values[1]), most(m_values[2])});
    }
    /// The plane's depth at a vertex of the other triangle, times the doubled area: |value| <
    /// 2^126.
    Int128 depthAt(std::size_t vertex, const std::array<Attribute, 3> &z) const
    {
        return Int128(at(0, vertex)) * z[2] + Int128(at(1, vertex)) * z[0]
            + Int128(at(2, vertex)) * z[1];
    }
    Int128 area() const { return m_area; } ///< doubled, unsigned

private:
    static Integer function(const Triangle &of, std::size_t edge, const LatticePoint &point)
    {
        const LatticePoint &a = of.vertices[edge].position;
        const LatticePoint &b = of.vertices[(edge + 1) % 3].position;
        return Integer(b.x - a.x) * Integer(point.y - a.y)
            - Integer(point.x - a.x) * Integer(b.y - a.y);
    }

    std::array<PerVertex, 3> m_values;
    Integer m_area = 0;
};

template <class Integer>
bool haveOppositeSigns(const Integer &a, const Integer &b)
{
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

/// How much farther the later of two triangles is, as positive multiples of the difference.
template <class Integer>
class DepthDifference {
public:
    using Edges = EdgesAtVertices<Integer>;

    DepthDifference(const DepthTriangle &earlier, const Edges &earlierEdges,
                    const DepthTriangle &later, const Edges &laterEdges)
        : m_earlierEdges(earlierEdges)
        , m_laterEdges(laterEdges)
        , m_earlier(earlier)
        , m_later(later)
    {
    }

    /// Whether it is positive at a corner of the polygon in which they overlap or, where they
    /// touch, at a vertex.
    bool isPositive() const
    {
        const bool touch = m_earlierEdges.parting() == 0 || m_laterEdges.parting() == 0;
        return isPositiveAtVertex() || (!touch && isPositiveAtCrossing());
    }

private:
    Int128 atEarlier(std::size_t vertex) const
    {
        return m_laterEdges.depthAt(vertex, m_later.z) - m_laterEdges.area() * m_earlier.z[vertex];
    }
    Int128 atLater(std::size_t vertex) const
    {
        return m_earlierEdges.area() * m_later.z[vertex]
            - m_earlierEdges.depthAt(vertex, m_earlier.z);
    }

    bool isPositiveAtVertex() const
    {
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            if ((m_laterEdges.isInside(vertex) && atEarlier(vertex) > 0)
                || (m_earlierEdges.isInside(vertex) && atLater(vertex) > 0))
                return true;
        }
        return false;
    }

    bool isPositiveAtCrossing() const
    {
        for (std::size_t ofEarlier = 0; ofEarlier < 3; ++ofEarlier) {
            for (std::size_t ofLater = 0; ofLater < 3; ++ofLater) {
                if (isPositiveWhereCrossed(ofEarlier, ofLater))
                    return true;
            }
        }
        return false;
    }

    /// Whether it is positive where the earlier triangle's edge from vertex k to k + 1 crosses one
    /// of the later's.
    bool isPositiveWhereCrossed(std::size_t k, std::size_t ofLater) const
    {
        const std::size_t next = (k + 1) % 3;
        const Integer from = m_laterEdges.at(ofLater, k);
        const Integer to = m_laterEdges.at(ofLater, next);
        if (!haveOppositeSigns(from, to)
            || !haveOppositeSigns(m_earlierEdges.at(k, ofLater),
                                  m_earlierEdges.at(k, (ofLater + 1) % 3)))
            return false;
        const Int128 atFrom = atEarlier(k);
        const Int128 atTo = atEarlier(next);
        if (!haveOppositeSigns(atFrom, atTo))
            return atFrom > 0 || atTo > 0;
        // At the crossing each end is weighted by the other end's distance: below 2^206.
        return Int256(atFrom) * Int256(absolute(to)) + Int256(atTo) * Int256(absolute(from)) > 0;
    }

    const Edges &m_earlierEdges; ///< the earlier triangle's edges at the later's vertices
    const Edges &m_laterEdges;
    const DepthTriangle &m_earlier;
    const DepthTriangle &m_later;
};

template <class Integer>
PlaneOrder orderOf(const DepthTriangle &earlier, const DepthTriangle &later, FillRule rule)
{
    using Edges = EdgesAtVertices<Integer>;
    const auto part = [rule](const Edges &edges) {
        const Integer parting = edges.parting();
        return parting < 0 || (parting == 0 && rule != FillRule::Closed);
    };
    const Edges earlierEdges(*earlier.triangle, *later.triangle);
    if (part(earlierEdges))
        return PlaneOrder::Apart;
    const Edges laterEdges(*later.triangle, *earlier.triangle);
    if (part(laterEdges))
        return PlaneOrder::Apart;
    const DepthDifference<Integer> difference(earlier, earlierEdges, later, laterEdges);
    return difference.isPositive() ? PlaneOrder::Behind : PlaneOrder::NotBehind;
}

} // namespace

PlaneOrder planeOrderOf(const DepthTriangle &earlier, const DepthTriangle &later, FillRule rule)
{
    const bool isNarrow = integerWidthFor(*earlier.triangle) == IntegerWidth::Bits64
        && integerWidthFor(*later.triangle) == IntegerWidth::Bits64;
    return isNarrow ? orderOf<std::int64_t>(earlier, later, rule)
                    : orderOf<Int128>(earlier, later, rule);
}

} // namespace pixelplumb
