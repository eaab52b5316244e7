// SPDX-License-Identifier: GPL-3.0-or-later
// The set-up of a vector of triangles at once. Compiled once for each instruction set.
#include "core/fast/batchbox-inl.h"
#include "core/fast/batchlines-inl.h"
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

/// Triangles in the lanes of a vector of doubles, in which every product below is exact: corners
/// within ±2^23, differences within ±2^24, areas and edge functions below 2^50, colour gradients
/// below 255·2^25.
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
        for (std::size_t i = 0; i < m_batch.size; i += lanesOf<Reals>)
            setUpFrom(i);
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
    static Real extracted(Integer packedLevels, std::size_t channel)
    {
        const Integer shifted = hn::ShiftRightSame(packedLevels, int(8 * channel));
        return hn::PromoteTo(reals, hn::And(shifted, hn::Set(integers, 255)));
    }
    /// The nearest integer in the low 51 bits of 1.5·2^52 + value: the sum has no bits below 1.
    static hn::Vec<Words> rounded(Real value, Real bias)
    {
        const Real shifted = hn::Add(value, real(0x1.8p52));
        return hn::BitCast(words, hn::Add(shifted, bias));
    }

    void setUpFrom(std::size_t i)
    {
        const BatchBox<Rule, Reals> box(m_batch, i, m_width, m_height);
        const Real x0 = loaded(m_batch.x[0], i);
        const Real y0 = loaded(m_batch.y[0], i);
        const Real x1 = hn::Sub(loaded(m_batch.x[1], i), x0);
        const Real y1 = hn::Sub(loaded(m_batch.y[1], i), y0);
        const Real x2 = hn::Sub(loaded(m_batch.x[2], i), x0);
        const Real y2 = hn::Sub(loaded(m_batch.y[2], i), y0);
        const Real signedArea = hn::Sub(hn::Mul(x1, y2), hn::Mul(x2, y1));
        hn::Store(signedArea, reals, m_batch.signedArea.data() + i);
        const Real sign = hn::CopySignToAbs(real(1), signedArea);
        const Real along = hn::Sub(hn::Mul(box.column, real(256)), x0);
        const Real up = hn::Sub(hn::Mul(box.row, real(256)), y0);

        const auto isFlat = flatFrom(i);
        const auto hasNarrowWords
            = setUpColours(i,
                           {hn::Mul(sign, x1), hn::Mul(sign, y1), hn::Mul(sign, x2),
                            hn::Mul(sign, y2), hn::Abs(signedArea), along, up, box.steps});
        const auto isSmall = hn::And(hasNarrowWords, box.isSmall);
        add(isFlat, i, m_batch.flat);
        add(isSmall, i, m_batch.small);
        add(box.isNarrow, i, m_batch.narrow);
        setUpEdge(i, 0, sign, x1, y1, along, up);
        setUpEdge(i, 1, sign, hn::Sub(x2, x1), hn::Sub(y2, y1), hn::Sub(along, x1),
                  hn::Sub(up, y1));
        setUpEdge(i, 2, sign, hn::Neg(x2), hn::Neg(y2), hn::Sub(along, x2), hn::Sub(up, y2));
        if (!hn::AllTrue(reals, isSmall)) {
            // Rows of one colour are long runs of stores; a strip of a wide box would be all masks.
            const auto spansRows = hn::And(box.isBeyondStrip, hn::Or(isFlat, box.isWide));
            add(spansRows, i, m_batch.spansRows);
            BatchLines<Rule, Reals>(m_batch, i, sign, spansRows).run();
        }
    }

    /// Adds the triangles of the lanes in `mask` to a set.
    static void add(hn::Mask<Reals> mask, std::size_t i, TriangleBatch::Set &set)
    {
        std::array<std::uint8_t, 8> bits = {};
        hn::StoreMaskBits(reals, mask, bits.data());
        set |= TriangleBatch::Set(bits[0]) << i;
    }

    hn::Mask<Reals> flatFrom(std::size_t i) const
    {
        const Integer colour0 = packedLevels(0, i);
        const auto differs
            = hn::Or(hn::Xor(colour0, packedLevels(1, i)), hn::Xor(colour0, packedLevels(2, i)));
        return hn::Eq(hn::PromoteTo(reals, differs), hn::Zero(reals));
    }

    /// Doubled area over the square of the lattice's common step: the least of the corners' lowest
    /// set bits, at most one pixel.
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

    struct Plane {
        Real x1, y1, x2, y2; ///< corners from the first one, mirrored where the area is negative
        Real area; ///< doubled
        Real along, up; ///< the first sample of the box from the first corner
        Real steps;
    };

    /// Returns where 24-bit words are exact.
    hn::Mask<Reals> setUpColours(std::size_t i, const Plane &plane)
    {
        const Real reduced = reducedArea(i, plane.area);
        hn::Store(reduced, reals, m_batch.reducedArea.data() + i);
        const Real resolution = hn::Mul(hn::Mul(real(4), reduced), plane.steps);
        hn::Store(resolution, reals, m_batch.resolution.data() + i);
        const auto isNarrow = hn::Lt(resolution, real(resolutionLimit(narrowFractionBits)));
        const Real stepsPerLevel = hn::IfThenElse(isNarrow, real(0x1p24), real(0x1p40));
        const Real scale = hn::Div(stepsPerLevel, plane.area);
        const Real half
            = m_rounding == ByteRounding::Nearest ? hn::Mul(stepsPerLevel, real(0.5)) : real(0);
        const Real bias = hn::Add(half, plane.steps);
        const auto isNarrowWord = hn::RebindMask(words, isNarrow);

        Real magnitude = real(0);
        const Integer colour0 = packedLevels(0, i);
        const Integer colour1 = packedLevels(1, i);
        const Integer colour2 = packedLevels(2, i);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Real c0 = extracted(colour0, channel);
            const Real c1 = hn::Sub(extracted(colour1, channel), c0);
            const Real c2 = hn::Sub(extracted(colour2, channel), c0);
            const Real gradientX = hn::Sub(hn::Mul(c1, plane.y2), hn::Mul(c2, plane.y1));
            const Real gradientY = hn::Sub(hn::Mul(c2, plane.x1), hn::Mul(c1, plane.x2));
            const Real start = hn::Mul(
                hn::Add(hn::Mul(c0, plane.area),
                        hn::Add(hn::Mul(gradientX, plane.along), hn::Mul(gradientY, plane.up))),
                scale);
            const Real pixelScale = hn::Mul(scale, real(256));
            const Real perColumn = hn::Mul(gradientX, pixelScale);
            const Real perRow = hn::Mul(gradientY, pixelScale);
            magnitude = hn::Max(hn::Max(magnitude, hn::Abs(start)),
                                hn::Max(hn::Abs(perColumn), hn::Abs(perRow)));
            storeWord(rounded(start, bias), isNarrowWord, m_batch.start[channel].data() + i);
            storeWord(rounded(perColumn, real(0)), isNarrowWord,
                      m_batch.perColumn[channel].data() + i);
            storeWord(rounded(perRow, real(0)), isNarrowWord, m_batch.perRow[channel].data() + i);
        }
        hn::Store(magnitude, reals, m_batch.magnitude.data() + i);
        // Not so where the area is 0: scale and magnitude are infinite or no numbers there.
        return hn::And(
            isNarrow,
            hn::And(hn::Lt(magnitude, real(magnitudeLimit)), hn::Gt(plane.area, real(0))));
    }

    Integer packedLevels(std::size_t corner, std::size_t i) const
    {
        const hn::RebindToUnsigned<Integers> unsignedIntegers;
        return hn::BitCast(integers, hn::Load(unsignedIntegers, m_batch.colour[corner].data() + i));
    }

    /// Moves the level to the top byte.
    template <class IsNarrow>
    static void storeWord(hn::Vec<Words> word, IsNarrow isNarrow, std::uint64_t *to)
    {
        constexpr int narrowShift = wideFractionBits - narrowFractionBits;
        constexpr int middleShift = wideFractionBits - middleFractionBits;
        hn::Store(hn::IfThenElse(isNarrow, hn::ShiftLeft<narrowShift>(word),
                                 hn::ShiftLeft<middleShift>(word)),
                  words, to);
    }

    /// E = ΔX·(y − Ya) − ΔY·(x − Xa), mirrored so that the inside is positive, less 1 where the
    /// rule does not own the edge.
    void setUpEdge(std::size_t i, std::size_t edge, Real sign, Real dx, Real dy, Real along,
                   Real up)
    {
        const Real perRow = hn::Mul(sign, dx);
        const Real perColumn = hn::Mul(sign, hn::Neg(dy));
        Real value = hn::Add(hn::Mul(perRow, up), hn::Mul(perColumn, along));
        if constexpr (Rule != FillRule::Closed) {
            const auto owned = ownsItsSamples(reals, perRow, perColumn);
            value = hn::Sub(value, hn::IfThenElse(owned, hn::Zero(reals), real(1)));
        }
        storeSaturated(value, m_batch.edge[edge].data() + i);
        storeSaturated(hn::Mul(perColumn, real(256)), m_batch.edgePerColumn[edge].data() + i);
        storeSaturated(hn::Mul(perRow, real(256)), m_batch.edgePerRow[edge].data() + i);
    }

    static void storeSaturated(Real value, std::int32_t *to)
    {
        hn::Store(hn::DemoteTo(integers, value), integers, to);
    }

    TriangleBatch &m_batch;
    ByteRounding m_rounding;
    std::int32_t m_width;
    std::int32_t m_height;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
