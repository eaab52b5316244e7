// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/planeorder.h"

#include "core/number/wideinteger.h"

#include <algorithm>

namespace pixelplumb {

namespace {

using PerVertex = std::array<Int128, 3>;

/// The edge functions of one triangle at the vertices of another, positive inside: [edge][vertex],
/// edges from vertex k to k + 1.
class EdgesAtVertices {
public:
    EdgesAtVertices(const Triangle &of, const Triangle &at)
    {
        const Int128 signedArea = doubledArea(of);
        const Int128 sign = signedArea < 0 ? -1 : 1;
        m_area = signedArea * sign;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const LatticePoint &a = of.vertices[edge].position;
            const LatticePoint &b = of.vertices[(edge + 1) % 3].position;
            for (std::size_t vertex = 0; vertex < 3; ++vertex)
                m_values[edge][vertex] = sign * doubledArea(a, b, at.vertices[vertex].position);
        }
    }

    Int128 at(std::size_t edge, std::size_t vertex) const { return m_values[edge][vertex]; }
    bool isInside(std::size_t vertex) const
    {
        return at(0, vertex) >= 0 && at(1, vertex) >= 0 && at(2, vertex) >= 0;
    }
    /// Whether one of the edges has all of the other triangle on its outer side: two convex figures
    /// that are apart are parted by an edge of one of them.
    bool hasPartingEdge(FillRule rule) const
    {
        const Int128 least = rule == FillRule::Closed ? 0 : 1;
        return std::ranges::any_of(m_values, [least](const PerVertex &values) {
            return std::ranges::all_of(values, [least](Int128 value) { return value < least; });
        });
    }
    /// The plane's depth at a vertex of the other, times the doubled area: |value| < 2^126.
    Int128 depthAt(std::size_t vertex, const std::array<Attribute, 3> &z) const
    {
        return at(0, vertex) * z[2] + at(1, vertex) * z[0] + at(2, vertex) * z[1];
    }
    Int128 area() const { return m_area; } ///< doubled, without sign

private:
    std::array<PerVertex, 3> m_values;
    Int128 m_area = 0;
};

bool haveOppositeSigns(Int128 a, Int128 b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

/// Two triangles and by how much the later one is farther, in multiples > 0 of the difference.
class DepthDifference {
public:
    DepthDifference(const DepthTriangle &earlier, const DepthTriangle &later)
        : m_earlierEdges(*earlier.triangle, *later.triangle)
        , m_laterEdges(*later.triangle, *earlier.triangle)
        , m_earlier(earlier)
        , m_later(later)
    {
    }

    bool areApart(FillRule rule) const
    {
        return m_earlierEdges.hasPartingEdge(rule) || m_laterEdges.hasPartingEdge(rule);
    }

    bool isPositiveSomewhere() const
    {
        PerVertex atEarlier;
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
            atEarlier[vertex] = m_laterEdges.depthAt(vertex, m_later.z)
                - m_laterEdges.area() * m_earlier.z[vertex];
            if (atEarlier[vertex] > 0 && m_laterEdges.isInside(vertex))
                return true;
            const Int128 atLater = m_earlierEdges.area() * m_later.z[vertex]
                - m_earlierEdges.depthAt(vertex, m_earlier.z);
            if (atLater > 0 && m_earlierEdges.isInside(vertex))
                return true;
        }
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (isPositiveWhereCrossed(edge, atEarlier))
                return true;
        }
        return false;
    }

private:
    /// Where the earlier triangle's edge from vertex k to k + 1 is crossed by the later one's.
    bool isPositiveWhereCrossed(std::size_t k, const PerVertex &atEarlier) const
    {
        const std::size_t next = (k + 1) % 3;
        if (atEarlier[k] <= 0 && atEarlier[next] <= 0)
            return false;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const Int128 from = m_laterEdges.at(edge, k);
            const Int128 to = m_laterEdges.at(edge, next);
            if (!haveOppositeSigns(from, to)
                || !haveOppositeSigns(m_earlierEdges.at(k, edge),
                                      m_earlierEdges.at(k, (edge + 1) % 3)))
                continue;
            // At the crossing the ends weigh by the other end's distance: below 2^206.
            const Int256 weighted = Int256(atEarlier[k]) * Int256(absolute(to))
                + Int256(atEarlier[next]) * Int256(absolute(from));
            if (weighted > 0)
                return true;
        }
        return false;
    }

    EdgesAtVertices m_earlierEdges; ///< the earlier triangle's at the later one's vertices
    EdgesAtVertices m_laterEdges;
    const DepthTriangle &m_earlier;
    const DepthTriangle &m_later;
};

} // namespace

PlaneOrder planeOrderOf(const DepthTriangle &earlier, const DepthTriangle &later, FillRule rule)
{
    const DepthDifference difference(earlier, later);
    if (difference.areApart(rule))
        return PlaneOrder::Apart;
    return difference.isPositiveSomewhere() ? PlaneOrder::Behind : PlaneOrder::NotBehind;
}

} // namespace pixelplumb
