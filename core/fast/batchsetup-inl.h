// SPDX-License-Identifier: GPL-3.0-or-later
// The set-up of a vector of triangles. Compiled once for each instruction set.
#include "core/fast/batchbox-inl.h"
#include "core/fast/batchlines-inl.h"
#include "core/fast/batchpixels-inl.h"
#include "core/fast/colourplane.h"
#include "core/fast/pixelvectors-inl.h"

#if defined(PIXELPLUMB_BATCHSETUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHSETUP_INL
#undef PIXELPLUMB_BATCHSETUP_INL
#else
#define PIXELPLUMB_BATCHSETUP_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sets up triangles in the lanes of a vector of doubles, in which every product below is exact:
/// corners within ±2^23, differences within ±2^24, areas and edge functions below 2^50, colour
/// gradients below 255·2^25.
template <FillRule Rule>
class BatchSetUp {
    using Reals = hn::CappedTag<double, TriangleBatch::capacity>;
    using Integers = hn::Rebind<std::int32_t, Reals>;
    using Words = hn::RebindToUnsigned<Reals>;
    using Real = hn::Vec<Reals>;
    using Integer = hn::Vec<Integers>;

public:
    BatchSetUp(TriangleBatch &batch, ByteRounding rounding, std::int32_t width, std::int32_t height)
        : m_batch(batch)
        , m_rounding(rounding)
        , m_width(width)
        , m_height(height)
    {
    }

    void run()
    {
        m_batch.flat = m_batch.small = m_batch.narrow = m_batch.spansRows = 0;
        BatchPixels<Rule> pixels(m_batch, m_rounding, m_width, m_height);
        for (std::size_t i = 0; i < m_batch.size; i += pixels.lanes) {
            if (pixels.setUpFrom(i))
                continue;
            for (std::size_t k = i; k < i + pixels.lanes; k += lanesOf<Reals>)
                setUpFrom(k);
        }
    }

private:
    static constexpr Reals reals{};
    static constexpr Integers integers{};
    static constexpr Words words{};

    static Real real(double value) { return hn::Set(reals, value); }
    static Real loaded(const TriangleBatch::Array<std::int32_t> &array, std::size_t i)
    {
        return hn::PromoteTo(reals, hn::Load(integers, array.data() + i));
    }

    void setUpFrom(std::size_t i)
    {
        const BatchBox<Rule, Reals> box(m_batch, i, m_width, m_height);
        const Real x0 = loaded(m_batch.x[0], i);
        const Real y0 = loaded(m_batch.y[0], i);
        BatchCorners<Reals> corners;
        corners.x1 = hn::Sub(loaded(m_batch.x[1], i), x0);
        corners.y1 = hn::Sub(loaded(m_batch.y[1], i), y0);
        corners.x2 = hn::Sub(loaded(m_batch.x[2], i), x0);
        corners.y2 = hn::Sub(loaded(m_batch.y[2], i), y0);
        corners.along = hn::Sub(hn::Mul(box.column, real(256)), x0);
        corners.up = hn::Sub(hn::Mul(box.row, real(256)), y0);
        corners.mirror();
        hn::Store(hn::Mul(corners.sign, corners.area), reals, m_batch.signedArea.data() + i);

        const auto levels = levelsAt(integers, m_batch, i);
        const auto hasOneColour
            = hn::Eq(hn::PromoteTo(reals, differences(levels)), hn::Zero(reals));
        const auto hasNarrowWords = setUpColours(i, levels, corners, box.steps);
        const auto isSmall = hn::And(hasNarrowWords, box.isSmall);
        addTo(reals, hasOneColour, i, m_batch.flat);
        addTo(reals, isSmall, i, m_batch.small);
        addTo(reals, box.isNarrow, i, m_batch.narrow);
        BatchEdges<Rule, unitsPerPixel, Reals>(m_batch, i, corners);
        if (!hn::AllTrue(reals, isSmall)) {
            // Rows of one colour are long runs of stores; strips of a wide box would be all masked
            // stores.
            const auto spansRows = hn::And(box.isBeyondStrip, hn::Or(hasOneColour, box.isWide));
            addTo(reals, spansRows, i, m_batch.spansRows);
            BatchLines<Rule, Reals>(m_batch, i, corners.sign, spansRows).run();
        }
    }

    /// Doubled area over the square of the lattice's common step: the lowest bit set in any
    /// coordinate, at most one pixel.
    Real reducedArea(std::size_t i, Real area)
    {
        Integer bits = hn::Set(integers, 256);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            bits = hn::Or(bits, hn::Load(integers, m_batch.x[corner].data() + i));
            bits = hn::Or(bits, hn::Load(integers, m_batch.y[corner].data() + i));
        }
        const Real step = hn::PromoteTo(reals, hn::And(bits, hn::Neg(bits)));
        return hn::Div(area, hn::Mul(step, step)); // exact: step is a power of two
    }

    /// `steps`: n + 1. Returns the lanes in which 24-bit words are exact.
    hn::Mask<Reals> setUpColours(std::size_t i, const std::array<Integer, 3> &levels,
                                 const BatchCorners<Reals> &corners, Real steps)
    {
        const Real area = corners.area;
        const Real reduced = reducedArea(i, area);
        hn::Store(reduced, reals, m_batch.reducedArea.data() + i);
        const Real resolution = hn::Mul(hn::Mul(real(4), reduced), steps);
        hn::Store(resolution, reals, m_batch.resolution.data() + i);
        const auto isNarrow = hn::Lt(resolution, real(resolutionLimit(narrowFractionBits)));
        const Real stepsPerLevel = hn::IfThenElse(isNarrow, real(0x1p24), real(0x1p40));
        const Real scale = hn::Div(stepsPerLevel, area);
        const Real half
            = m_rounding == ByteRounding::Nearest ? hn::Mul(stepsPerLevel, real(0.5)) : real(0);
        const Real withBias = hn::Add(hn::Add(half, steps), real(toWord));
        const auto isNarrowWord = hn::RebindMask(words, isNarrow);

        const Real pixelScale = hn::Mul(scale, real(256));
        Real magnitude = real(0);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const BatchChannel<Reals> plane(levels, channel, corners);
            const Real start = hn::Mul(plane.start, scale);
            const Real perColumn = hn::Mul(plane.perColumn, pixelScale);
            const Real perRow = hn::Mul(plane.perRow, pixelScale);
            magnitude = hn::Max(hn::Max(magnitude, hn::Abs(start)),
                                hn::Max(hn::Abs(perColumn), hn::Abs(perRow)));
            const auto put = [&](Real sum, std::uint64_t *wide, std::uint32_t *narrow) HWY_ATTR {
                storeWord(hn::BitCast(words, sum), isNarrowWord, wide + i);
                storeNarrow(reals, sum, narrow + i);
            };
            put(hn::Add(start, withBias), m_batch.start[channel].data(),
                m_batch.narrowStart[channel].data());
            put(hn::Add(perColumn, real(toWord)), m_batch.perColumn[channel].data(),
                m_batch.narrowPerColumn[channel].data());
            put(hn::Add(perRow, real(toWord)), m_batch.perRow[channel].data(),
                m_batch.narrowPerRow[channel].data());
        }
        hn::Store(magnitude, reals, m_batch.magnitude.data() + i);
        // False where the area is 0: there scale and magnitude are infinite or NaN.
        return hn::And(isNarrow,
                       hn::And(hn::Lt(magnitude, real(magnitudeLimit)), hn::Gt(area, real(0))));
    }

    /// Stores the word with the level moved to the top byte.
    template <class IsNarrow>
    static void storeWord(hn::Vec<Words> word, IsNarrow isNarrow, std::uint64_t *to)
    {
        constexpr int narrowShift = wideFractionBits - narrowFractionBits;
        constexpr int middleShift = wideFractionBits - middleFractionBits;
        hn::Store(hn::IfThenElse(isNarrow, hn::ShiftLeft<narrowShift>(word),
                                 hn::ShiftLeft<middleShift>(word)),
                  words, to);
    }

    TriangleBatch &m_batch;
    ByteRounding m_rounding;
    std::int32_t m_width;
    std::int32_t m_height;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
