// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/depthwitness.h"

#include "core/number/wideinteger.h"
#include "core/scan/edgetestsetup.h"
#include "core/scan/planearithmetic.h"

namespace pixelplumb {

namespace {

using Exact = ExactPlane<Int128>;

/// A triangle whose coverage and depth are asked for sample by sample.
class SampledTriangle {
public:
    SampledTriangle(const DepthTriangle &triangle, const BoundaryRule &rule)
        : m_setUp(edgeTestSetUp<Exact, canonicalEdgeEquationsForm>(*triangle.triangle, rule, {}))
        , m_z(triangle.z)
    {
    }

    /// Moves to a sample; whether it is covered.
    bool moveTo(const SamplePlace &sample)
    {
        const LatticePoint point = latticePixel(sample.x, sample.y);
        for (std::size_t line = 0; line < 3; ++line) {
            m_values[line] = m_setUp.lines[line].valueAt<canonicalEdgeEquationsForm.line>(point);
            if (!Exact::isInside(m_values[line], m_setUp.ownsTie[line]))
                return false;
        }
        return true;
    }
    /// The depth there is numerator / denominator.
    Int256 numerator() const
    {
        return Int256(m_values[0] * m_z[2] + m_values[1] * m_z[0] + m_values[2] * m_z[1]);
    }
    Int256 denominator() const { return Int256(m_setUp.atOpposite[0]); }

private:
    EdgeTestSetUp<Exact> m_setUp;
    std::array<Attribute, 3> m_z;
    std::array<Int128, 3> m_values = {};
};

/// What a depth buffer of so many bits keeps: ⌊z·(2^n − 1) + ½⌋ of z within 0 … 1.
Int256 depthLevel(const SampledTriangle &triangle, DepthFormat format)
{
    const Int256 largest = (Int256(1) << int(format)) - 1;
    const Int256 one = triangle.denominator() * attributeOne;
    if (triangle.numerator() <= 0)
        return 0;
    if (triangle.numerator() >= one)
        return largest;
    return (2 * triangle.numerator() * largest + one) / (2 * one);
}

bool isFarther(const SampledTriangle &later, const SampledTriangle &earlier, DepthFormat format)
{
    if (format != DepthFormat::Exact)
        return depthLevel(later, format) > depthLevel(earlier, format);
    return later.numerator() * earlier.denominator() > earlier.numerator() * later.denominator();
}

} // namespace

WitnessSearch searchWitness(const DepthTriangle &earlier, const DepthTriangle &later,
                            const SampleBox &window, const BoundaryRule &rule, DepthFormat format)
{
    WitnessSearch search;
    search.wasComplete = true;
    if (window.isEmpty())
        return search;
    // Prime to the sizes that scenes like, and odd: rows and columns are not missed in step.
    constexpr std::int64_t mostAlongASide = 61;
    const auto stepOf
        = [&](std::int64_t count) { return count <= mostAlongASide ? 1 : count / mostAlongASide; };
    const std::int64_t stepX = stepOf(window.endX - window.firstX);
    const std::int64_t stepY = stepOf(window.endY - window.firstY);
    search.wasComplete = stepX == 1 && stepY == 1;
    SampledTriangle early(earlier, rule);
    SampledTriangle late(later, rule);
    for (std::int64_t y = window.firstY + stepY / 2; y < window.endY; y += stepY) {
        for (std::int64_t x = window.firstX + stepX / 2; x < window.endX; x += stepX) {
            ++search.samples;
            if (early.moveTo({x, y}) && late.moveTo({x, y}) && isFarther(late, early, format)) {
                search.found = SamplePlace{x, y};
                return search;
            }
        }
    }
    return search;
}

} // namespace pixelplumb
