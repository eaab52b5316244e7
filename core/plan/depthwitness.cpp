// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/depthwitness.h"

#include "core/plan/drawnplane.h"

#include <array>
#include <vector>

namespace pixelplumb {

namespace {

/// One sample of a group of pixels.
struct PixelSamples {
    enum class Of : std::uint8_t { AllPixels, EdgePixels, OtherPixels };

    LatticePoint place; ///< offset in the pixel
    Of of = Of::AllPixels;
};

/// Pixels without an edge come first: most have none.
std::vector<PixelSamples> samplesOfPixels(Antialiasing antialiasing)
{
    const std::span<const LatticePoint> pattern = samplePattern(antialiasing);
    std::vector<PixelSamples> samples;
    samples.push_back(
        {{0, 0}, pattern.empty() ? PixelSamples::Of::AllPixels : PixelSamples::Of::OtherPixels});
    for (const LatticePoint &place : pattern)
        samples.push_back({place, PixelSamples::Of::EdgePixels});
    return samples;
}

/// A depth as a buffer of `format` bits stores it: ⌊z·(2^n − 1) + ½⌋ with z clamped to 0 … 1.
Int256 depthLevel(const DrawnPlane &plane, const SamplePlace &at, DepthFormat format)
{
    const Int256 largest = (Int256(1) << int(format)) - 1;
    const Int256 numerator = plane.depth.at(at.x, at.y);
    const Int256 one = plane.denominator * attributeOne;
    if (numerator <= 0)
        return 0;
    if (numerator >= one)
        return largest;
    return (2 * numerator * largest + one) / (2 * one);
}

/// Keeps the rows in which both forms are above 0 somewhere, at a column or between two: eliminates
/// x (Fourier).
template <class Integer>
void keepRowsOfBoth(RowPixels &rows, const PixelForm<Integer> &a, const PixelForm<Integer> &b)
{
    const auto keepRowsOf = [&rows](const PixelForm<Integer> &form) {
        rows.keepPositive(PixelForm<Integer>{form.y, 0, form.constant}, 0);
    };
    if (a.x == 0)
        keepRowsOf(a);
    if (b.x == 0)
        keepRowsOf(b);
    if (a.x > 0 && b.x < 0)
        keepRowsOf(a * Integer(-b.x) + b * a.x);
    if (a.x < 0 && b.x > 0)
        keepRowsOf(b * Integer(-a.x) + a * b.x);
}

/// Two triangles as seen by one sample of each pixel.
class DrawnPair {
public:
    DrawnPair(const DepthTriangle &earlier, const DepthTriangle &later, const PixelSamples &samples,
              const SampledFrame &where)
        : m_earlier(earlier, samples.place, where)
        , m_later(later, samples.place, where)
        , m_behind(m_later.depth * m_earlier.denominator
                   + m_earlier.depth * Int256(-m_later.denominator))
        , m_isNarrow(integerWidthFor(*earlier.triangle) == IntegerWidth::Bits64
                     && integerWidthFor(*later.triangle) == IntegerWidth::Bits64)
    {
    }

    /// Whether the later one may be farther somewhere in the window: a linear form is largest at a
    /// corner.
    bool mayBeBehind(const SampleBox &window) const
    {
        for (const std::int64_t x : {window.firstX, window.endX - 1}) {
            for (const std::int64_t y : {window.firstY, window.endY - 1}) {
                if (m_behind.at(x, y) > 0)
                    return true;
            }
        }
        return false;
    }
    /// The rows of the window in which, at some point, both are drawn and the later one is farther:
    /// none for most planes that cross beyond the triangles. Exact, but disregards horizons.
    RowPixels rowsBehind(const SampleBox &window) const
    {
        RowPixels rows = {window.firstY, window.endY};
        std::vector<PixelForm<Int128>> inside;
        inside.reserve(16);
        inside.push_back({1, 0, 1 - Int128(window.firstX)});
        inside.push_back({-1, 0, Int128(window.endX)});
        for (const DrawnPlane *plane : {&m_earlier, &m_later})
            inside.insert(inside.end(), plane->inside.begin(), plane->inside.end());
        for (std::size_t i = 0; i < inside.size() && !rows.isEmpty(); ++i) {
            const auto wide = widened<Int256>(inside[i]);
            for (std::size_t k = 0; k < i; ++k) {
                if (m_isNarrow)
                    keepRowsOfBoth(rows, inside[i], inside[k]);
                else
                    keepRowsOfBoth(rows, wide, widened<Int256>(inside[k]));
            }
            keepRowsOfBoth(rows, m_behind, wide);
        }
        return rows;
    }
    /// Keeps the part of a row where both are drawn and the later one is farther.
    void keepBehind(RowPixels &columns, std::int64_t row) const
    {
        m_earlier.keepDrawn(columns, row);
        if (!columns.isEmpty())
            m_later.keepDrawn(columns, row);
        if (!columns.isEmpty())
            columns.keepPositive(m_behind, row);
    }
    /// Whether a later one that is farther is also farther in the depth buffer.
    bool isKeptBehind(const SamplePlace &at, DepthFormat format) const
    {
        return format == DepthFormat::Exact
            || depthLevel(m_later, at, format) > depthLevel(m_earlier, at, format);
    }

private:
    DrawnPlane m_earlier, m_later;
    PixelForm<Int256> m_behind; ///< above 0 where the later one is farther
    bool m_isNarrow; ///< products of two edges' forms fit 128 bits
};

/// Searches the rows of a window for one sample of its pixels after the other.
class Search {
public:
    /// What finding the rows costs, in rows.
    static constexpr int stepsOfRows = 4;

    Search(const EdgePixels *edges, DepthFormat format, const WitnessWindow &window)
        : m_edges(edges)
        , m_format(format)
        , m_window(window)
    {
    }

    /// False once it has ended: with a witness, or at the step limit.
    bool goOn(const DrawnPair &pair, PixelSamples::Of of)
    {
        ++m_search.steps;
        if (!pair.mayBeBehind(m_window.pixels))
            return true;
        m_search.steps += stepsOfRows;
        const RowPixels rows = pair.rowsBehind(m_window.pixels);
        for (std::int64_t y = rows.first; y < rows.end; ++y) {
            if (++m_search.steps > m_window.mostSteps)
                return false;
            RowPixels columns = {m_window.pixels.firstX, m_window.pixels.endX};
            pair.keepBehind(columns, y);
            for (std::int64_t x = columns.first; x < columns.end; ++x) {
                if (++m_search.steps > m_window.mostSteps)
                    return false;
                if (!isOf(of, x, y) || !pair.isKeptBehind({x, y}, m_format))
                    continue;
                m_search.found = SamplePlace{x, y};
                return false;
            }
        }
        return true;
    }

    WitnessSearch done(bool wasComplete)
    {
        m_search.wasComplete = wasComplete || m_search.found;
        return m_search;
    }

private:
    bool isOf(PixelSamples::Of of, std::int64_t x, std::int64_t y) const
    {
        return of == PixelSamples::Of::AllPixels
            || m_edges->contains(x, y) == (of == PixelSamples::Of::EdgePixels);
    }

    const EdgePixels *m_edges;
    DepthFormat m_format;
    WitnessWindow m_window;
    WitnessSearch m_search;
};

} // namespace

WitnessSearch searchWitness(const DepthTriangle &earlier, const DepthTriangle &later,
                            const SampledFrame &where, const EdgePixels *edges, DepthFormat format,
                            const WitnessWindow &window)
{
    Search search(edges, format, window);
    if (window.pixels.isEmpty())
        return search.done(true);
    for (const PixelSamples &samples : samplesOfPixels(where.antialiasing)) {
        if (!search.goOn(DrawnPair(earlier, later, samples, where), samples.of))
            return search.done(false);
    }
    return search.done(true);
}

} // namespace pixelplumb
