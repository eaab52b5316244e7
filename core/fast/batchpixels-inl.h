// SPDX-License-Identifier: GPL-3.0-or-later
// The set-up of a vector of small triangles with whole-pixel corners. Compiled once for each
// instruction set.
#include "core/fast/batchbox-inl.h"
#include "core/fast/batchplanes-inl.h"
#include "core/fast/colourplane.h"

#if defined(PIXELPLUMB_BATCHPIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHPIXELS_INL
#undef PIXELPLUMB_BATCHPIXELS_INL
#else
#define PIXELPLUMB_BATCHPIXELS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Computes in floats of pixels what BatchSetUp computes in doubles of lattice units: the same
/// numbers to the last bit, up to powers of two, because each is an integer below 2^24. In a box of
/// at most 63 px a side, corners and samples are at most 63 apart; the doubled area is at most 63²,
/// edge functions at most twice that; gradients of levels up to 255 are at most 255 · 2 · 63 =
/// 32,130; and a colour at a sample of the box times the area is at most 255 · 63² + 2 · 32,130 ·
/// 63 < 2^23. 4 A' (n + 1) <= 4 · 63² · 126 < 2^21: 24-bit words are exact for all of them, and the
/// quotients are taken in doubles as in BatchSetUp.
template <FillRule Rule>
class BatchPixels {
    using Floats = hn::CappedTag<float, TriangleBatch::capacity>;
    using Integers = hn::Rebind<std::int32_t, Floats>;
    using Float = hn::Vec<Floats>;

public:
    static constexpr std::size_t lanes = lanesOf<Floats>;

    BatchPixels(TriangleBatch &batch, ByteRounding rounding, std::int32_t width,
                std::int32_t height)
        : m_batch(batch)
        , m_rounding(rounding)
        , m_width(width)
        , m_height(height)
    {
    }

    /// Sets up a vector of triangles. Returns false if one of them is neither such a triangle nor
    /// empty; then it has changed nothing that the set-up in doubles does not change too.
    HWY_INLINE bool setUpFrom(std::size_t i)
    {
        auto bits = hn::Zero(integers);
        for (std::size_t corner = 0; corner < 3; ++corner)
            bits = hn::Or3(bits, lattice(m_batch.x[corner], i), lattice(m_batch.y[corner], i));
        const auto isUnused = hn::Not(hn::FirstN(floats, m_batch.size - i));
        const auto fractions = hn::And(bits, hn::Set(integers, unitsPerPixel - 1));
        const auto isWhole = hn::RebindMask(floats, hn::Eq(fractions, hn::Zero(integers)));
        if (!hn::AllTrue(floats, hn::Or(isWhole, isUnused)))
            return false;
        const BatchBox<Rule, Floats> box(m_batch, i, m_width, m_height);
        const BatchCorners<Floats> corners = cornersFrom(i, box);
        const auto isSmall = hn::And(box.isSmall, hn::Gt(corners.area, hn::Zero(floats)));
        if (!hn::AllTrue(floats, hn::Or(hn::Or(isSmall, box.isEmpty), isUnused)))
            return false;
        addTo(floats, isSmall, i, m_batch.small);
        addTo(floats, box.isNarrow, i, m_batch.narrow);
        BatchEdges<Rule, 1, Floats>(m_batch, i, corners);
        setUpColours(i, corners, box.steps);
        return true;
    }

private:
    static constexpr Floats floats{};
    static constexpr Integers integers{};
    using Numbers = std::array<float, lanes>;

    static hn::Vec<Integers> lattice(const TriangleBatch::Array<std::int32_t> &array, std::size_t i)
    {
        return hn::Load(integers, array.data() + i);
    }
    static Float pixels(const TriangleBatch::Array<std::int32_t> &array, std::size_t i)
    {
        return hn::ConvertTo(floats, hn::ShiftRight<8>(lattice(array, i)));
    }

    HWY_INLINE BatchCorners<Floats> cornersFrom(std::size_t i,
                                                const BatchBox<Rule, Floats> &box) const
    {
        const Float x0 = pixels(m_batch.x[0], i);
        const Float y0 = pixels(m_batch.y[0], i);
        BatchCorners<Floats> corners;
        corners.x1 = hn::Sub(pixels(m_batch.x[1], i), x0);
        corners.y1 = hn::Sub(pixels(m_batch.y[1], i), y0);
        corners.x2 = hn::Sub(pixels(m_batch.x[2], i), x0);
        corners.y2 = hn::Sub(pixels(m_batch.y[2], i), y0);
        corners.along = hn::Sub(box.column, x0);
        corners.up = hn::Sub(box.row, y0);
        corners.mirror();
        return corners;
    }

    HWY_INLINE void setUpColours(std::size_t i, const BatchCorners<Floats> &corners, Float steps)
    {
        const auto levels = levelsAt(integers, m_batch, i);
        const auto isFlat = hn::Eq(differences(levels), hn::Zero(integers));
        addTo(floats, hn::RebindMask(floats, isFlat), i, m_batch.flat);
        hn::Store(corners.area, floats, m_area.data());
        hn::Store(steps, floats, m_steps.data());
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const BatchChannel<Floats> plane(levels, channel, corners);
            hn::Store(plane.start, floats, m_start[channel].data());
            hn::Store(plane.perColumn, floats, m_perColumn[channel].data());
            hn::Store(plane.perRow, floats, m_perRow[channel].data());
        }
        for (std::size_t k = 0; k < lanes; k += lanesOf<Reals>)
            divideFrom(i, k);
    }

    using Reals = hn::CappedTag<double, TriangleBatch::capacity>;
    static constexpr Reals reals{};

    static hn::Vec<Reals> promoted(const Numbers &numbers, std::size_t k)
    {
        constexpr hn::Rebind<float, Reals> halves{};
        return hn::PromoteTo(reals, hn::Load(halves, numbers.data() + k));
    }

    HWY_INLINE void divideFrom(std::size_t i, std::size_t k)
    {
        const auto scale = hn::Div(hn::Set(reals, 0x1p24), promoted(m_area, k));
        const double half = m_rounding == ByteRounding::Nearest ? 0x1p23 : 0;
        const auto toWords = hn::Set(reals, toWord);
        const auto withBias = hn::Add(hn::Set(reals, toWord + half), promoted(m_steps, k));
        const auto put = [&](const Numbers &numerator, auto plus, std::uint32_t *to) HWY_ATTR {
            const auto quotient = hn::Mul(promoted(numerator, k), scale);
            storeNarrow(reals, hn::Add(quotient, plus), to + i + k);
        };
        for (std::size_t channel = 0; channel < 3; ++channel) {
            put(m_start[channel], withBias, m_batch.narrowStart[channel].data());
            put(m_perColumn[channel], toWords, m_batch.narrowPerColumn[channel].data());
            put(m_perRow[channel], toWords, m_batch.narrowPerRow[channel].data());
        }
    }

    TriangleBatch &m_batch;
    ByteRounding m_rounding;
    std::int32_t m_width;
    std::int32_t m_height;
    // Numerators, promoted to doubles when read back.
    alignas(64) Numbers m_area;
    alignas(64) Numbers m_steps;
    alignas(64) std::array<Numbers, 3> m_start;
    alignas(64) std::array<Numbers, 3> m_perColumn;
    alignas(64) std::array<Numbers, 3> m_perRow;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
