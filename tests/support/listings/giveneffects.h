// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "core/shade/shadedrun.h"
#include "tests/support/listings/listingstate.h"

namespace pixelplumb {

/// What the listing's head says is given, by the kernel's own functions in the kernel's numbers.
template <class N>
class GivenEffects {
public:
    using Number = BigRational;
    using Numbers = std::vector<Number>;

    GivenEffects(const TracedScene &traced, std::size_t index, DepthTest depth)
        : m_primitives(traced.primitives)
        , m_triangle(m_primitives.triangles[index])
        , m_material(materialOf(m_primitives.appearance, materialAt(index)))
        , m_lighting(m_primitives.appearance)
        , m_edges(m_primitives.triangles, traced.truth.view())
        , m_frame(traced.truth.view())
        , m_pattern(samplePattern(traced.antialiasing()))
        , m_depth(depth)
    {
    }

    ListingState::Given functions()
    {
        return {{u"level"_s, [this](const Numbers &z) { return Numbers{level(z[0])}; }},
                {u"texel"_s, [this](const Numbers &at) { return texel(at[0], at[1]); }},
                {u"light"_s, [this](const Numbers &values) { return light(values); }},
                {u"lit"_s,
                 [this](const Numbers &vertex) {
                     return bytes(m_triangle.vertices[vertex[0].convert_to<std::size_t>()].colour);
                 }},
                {u"area"_s,
                 [this](const Numbers &at) { return Numbers{areaAt(at).isEmpty() ? 0 : 1}; }},
                {u"share"_s,
                 [this](const Numbers &values) {
                     return Numbers{
                         areaAt({values[1], values[2]}).times(std::uint8_t(whole(values[0])))};
                 }},
                {u"rows"_s, [this](const Numbers &column) { return rows(whole(column[0])); }},
                {u"edge"_s,
                 [this](const Numbers &at) {
                     return Numbers{m_edges.contains(whole(at[0]), whole(at[1])) ? 1 : 0};
                 }},
                {u"way"_s, [this](const Numbers &sample) { return way(whole(sample[0])); }}};
    }

private:
    using Real = typename N::Real;

    static std::int64_t whole(const Number &value)
    {
        return numerator(value).convert_to<std::int64_t>();
    }
    static Numbers bytes(const Colour &colour)
    {
        return {colour.red(), colour.green(), colour.blue()};
    }
    int materialAt(std::size_t index) const
    {
        const TriangleAttributes *const attributes = m_primitives.attributesOf(index);
        return attributes ? attributes->material : noMaterial;
    }
    PixelArea areaAt(const Numbers &at) const
    {
        return PixelArea(m_triangle, whole(at[0]), whole(at[1]));
    }

    Number level(const Number &z) const
    {
        const std::uint32_t most = greatestDepthLevel(m_primitives.appearance.depthFormat);
        if (m_depth == DepthTest::Number)
            return z;
        if constexpr (N::isExact)
            return N::depthLevel(typename N::Number(numerator(z) * attributeOne),
                                 typename N::Number(denominator(z)), most);
        else
            return N::depthLevel(z.convert_to<Real>(), most);
    }
    Numbers texel(const Number &u, const Number &v) const
    {
        return bytes(m_material.filter == TextureFilter::Nearest
                         ? texelBy<TextureFilter::Nearest>(u, v)
                         : texelBy<TextureFilter::Bilinear>(u, v));
    }
    template <TextureFilter filter>
    Colour texelBy(const Number &u, const Number &v) const
    {
        if constexpr (N::isExact) {
            const BigInteger common = lcm(denominator(u), denominator(v));
            const auto over = [&](const Number &value) {
                return typename N::Number(BigInteger(numerator(Number(value * common)))
                                          * attributeOne);
            };
            return fetchTexels<filter, N>(m_material, over(u), over(v), typename N::Number(common))
                .texel;
        } else {
            return fetchTexels<filter, N>(m_material, u.convert_to<Real>(), v.convert_to<Real>(),
                                          Real(1))
                .texel;
        }
    }
    Numbers light(const Numbers &values) const
    {
        const auto vectorAt = [&](std::size_t first) {
            return Vector<Real>{values[first].convert_to<Real>(),
                                values[first + 1].convert_to<Real>(),
                                values[first + 2].convert_to<Real>()};
        };
        const auto byteAt = [&](std::size_t i) { return std::uint8_t(whole(values[i])); };
        LitSample<Real> lit = {};
        lit.place = vectorAt(6);
        lightSample(m_lighting, m_material, Colour{{byteAt(0), byteAt(1), byteAt(2)}}, vectorAt(3),
                    lit);
        return bytes(lit.colour);
    }
    Numbers rows(std::int64_t x) const
    {
        std::array<LatticePoint, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = m_triangle.vertices[std::size_t(sortedByColumn(m_triangle)[i])].position;
        const CoveredStrip strip = coveredStrip(corners, x);
        const std::int64_t first = std::max<std::int64_t>(strip.met.first, m_frame.firstRow);
        const std::int64_t end = std::max(std::min(strip.met.end, m_frame.endRow()), first);
        return {first, end - 1, std::clamp(strip.whole.first, first, end),
                std::clamp(strip.whole.end, first, end) - 1};
    }
    Numbers way(std::int64_t k) const
    {
        const auto placeOf = [&](std::int64_t sample) {
            return sample > 0 ? m_pattern[std::size_t(sample - 1)] : LatticePoint();
        };
        const LatticePoint from = placeOf(k - 1), to = placeOf(k);
        return {Number(to.x - from.x, unitsPerPixel), Number(to.y - from.y, unitsPerPixel)};
    }

    const Primitives &m_primitives;
    const Triangle &m_triangle;
    const Material &m_material;
    Lighting<Real> m_lighting;
    EdgePixels m_edges;
    FrameView m_frame;
    std::span<const LatticePoint> m_pattern;
    DepthTest m_depth;
};

} // namespace pixelplumb
