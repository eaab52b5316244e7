// SPDX-License-Identifier: GPL-3.0-or-later
// Edge functions and colour planes of a vector of triangles, in doubles or in floats. Compiled once
// for each instruction set.
#include "core/fast/batchlines-inl.h"
#include "core/fast/pixelvectors-inl.h"
#include "core/fast/trianglebatch.h"
#include "core/scan/scansettings.h"

#if defined(PIXELPLUMB_BATCHPLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHPLANES_INL
#undef PIXELPLUMB_BATCHPLANES_INL
#else
#define PIXELPLUMB_BATCHPLANES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Positions relative to each triangle's first corner, mirrored where the area is negative: in
/// lattice units or in pixels.
template <class Reals>
struct BatchCorners {
    using Real = hn::Vec<Reals>;

    Real x1, y1, x2, y2; ///< the other two corners
    Real along, up; ///< the first sample of the box, not mirrored
    Real area; ///< doubled
    Real sign; ///< 1, or −1 where the area was negative

    HWY_INLINE void mirror()
    {
        constexpr Reals reals{};
        const Real signedArea = hn::Sub(hn::Mul(x1, y2), hn::Mul(x2, y1));
        sign = hn::CopySignToAbs(hn::Set(reals, 1), signedArea);
        area = hn::Abs(signedArea);
        x1 = hn::Mul(sign, x1);
        y1 = hn::Mul(sign, y1);
        x2 = hn::Mul(sign, x2);
        y2 = hn::Mul(sign, y2);
    }
};

/// Adds the triangles of the lanes in `mask` to a set.
template <class Reals>
HWY_INLINE void addTo(Reals reals, hn::Mask<Reals> mask, std::size_t i, TriangleBatch::Set &set)
{
    std::array<std::uint8_t, 8> bits = {};
    hn::StoreMaskBits(reals, mask, bits.data());
    set |= (TriangleBatch::Set(bits[0]) | TriangleBatch::Set(bits[1]) << 8) << i;
}

/// Stores the three edge functions of each triangle and their changes per pixel in the batch. E =
/// ΔX·(y − Ya) − ΔY·(x − Xa), positive inside, less 1 where the rule does not own the edge. The
/// three add up to the doubled area.
template <FillRule Rule, int UnitsAPixel, class Reals>
class BatchEdges {
    using Real = hn::Vec<Reals>;

public:
    HWY_INLINE BatchEdges(TriangleBatch &batch, std::size_t i, const BatchCorners<Reals> &c)
        : m_batch(batch)
        , m_i(i)
    {
        const Real first = hn::Sub(hn::Mul(c.x1, c.up), hn::Mul(c.y1, c.along));
        const Real last = hn::Sub(hn::Mul(c.y2, c.along), hn::Mul(c.x2, c.up));
        set(0, first, c.x1, hn::Neg(c.y1));
        set(1, hn::Sub(c.area, hn::Add(first, last)), hn::Sub(c.x2, c.x1), hn::Sub(c.y1, c.y2));
        set(2, last, hn::Neg(c.x2), c.y2);
    }

private:
    static constexpr Reals reals{};
    static constexpr hn::Rebind<std::int32_t, Reals> integers{};

    HWY_INLINE void set(std::size_t edge, Real value, Real perRow, Real perColumn) const
    {
        if constexpr (Rule != FillRule::Closed) {
            const auto owned = ownsItsSamples(reals, perRow, perColumn);
            value = hn::Sub(value, hn::IfThenElse(owned, hn::Zero(reals), hn::Set(reals, 1)));
        }
        store(value, m_batch.edge[edge]);
        store(aPixel(perColumn), m_batch.edgePerColumn[edge]);
        store(aPixel(perRow), m_batch.edgePerRow[edge]);
    }

    HWY_INLINE static Real aPixel(Real aUnit)
    {
        if constexpr (UnitsAPixel == 1)
            return aUnit;
        else
            return hn::Mul(aUnit, hn::Set(reals, UnitsAPixel));
    }
    HWY_INLINE void store(Real value, TriangleBatch::Array<std::int32_t> &to) const
    {
        if constexpr (sizeof(hn::TFromD<Reals>) == sizeof(std::int32_t)) {
            // Within ±2^22: adding 1.5·2^23 puts the integer into the lowest bits of the float.
            const auto word = hn::BitCast(integers, hn::Add(value, hn::Set(reals, 0x1.8p23f)));
            hn::Store(hn::Sub(word, hn::Set(integers, 0x4b400000)), integers, to.data() + m_i);
        } else {
            hn::Store(hn::DemoteTo(integers, value), integers, to.data() + m_i); // saturates
        }
    }

    TriangleBatch &m_batch;
    std::size_t m_i;
};

/// A colour channel of each triangle, times the doubled area: at the first sample of the box, and
/// its change per unit.
template <class Reals>
struct BatchChannel {
    using Real = hn::Vec<Reals>;
    using Integer = hn::Vec<hn::Rebind<std::int32_t, Reals>>;

    Real start, perColumn, perRow;

    /// `levels` as 0x00bbggrr, one word per corner.
    HWY_INLINE BatchChannel(const std::array<Integer, 3> &levels, std::size_t channel,
                            const BatchCorners<Reals> &c)
    {
        const auto level = [&](std::size_t corner) HWY_ATTR {
            constexpr hn::Rebind<std::int32_t, Reals> integers{};
            const Integer shifted = hn::ShiftRightSame(levels[corner], int(8 * channel));
            return numbersOf(Reals(), hn::And(shifted, hn::Set(integers, 255)));
        };
        const Real c0 = level(0);
        const Real c1 = hn::Sub(level(1), c0);
        const Real c2 = hn::Sub(level(2), c0);
        perColumn = hn::Sub(hn::Mul(c1, c.y2), hn::Mul(c2, c.y1));
        perRow = hn::Sub(hn::Mul(c2, c.x1), hn::Mul(c1, c.x2));
        start = hn::Add(hn::Mul(c0, c.area),
                        hn::Add(hn::Mul(perColumn, c.along), hn::Mul(perRow, c.up)));
    }
};

/// The corners' colours of a vector of triangles, 0x00bbggrr.
template <class Integers>
HWY_INLINE std::array<hn::Vec<Integers>, 3> levelsAt(Integers integers, const TriangleBatch &batch,
                                                     std::size_t i)
{
    const auto at = [&](std::size_t corner) HWY_ATTR {
        constexpr hn::RebindToUnsigned<Integers> words{};
        return hn::BitCast(integers, hn::Load(words, batch.colour[corner].data() + i));
    };
    return {at(0), at(1), at(2)};
}

/// Zero where the three corners have the same colour.
template <class Integer>
HWY_INLINE Integer differences(const std::array<Integer, 3> &levels)
{
    return hn::Or(hn::Xor(levels[0], levels[1]), hn::Xor(levels[0], levels[2]));
}

/// Added to a double: the nearest integer is then in the low 51 bits of the sum, which has no bits
/// below 1.
inline constexpr double toWord = 0x1.8p52;

/// Stores the low 32 bits of each sum.
template <class Reals>
HWY_INLINE void storeNarrow(Reals, hn::Vec<Reals> sum, std::uint32_t *to)
{
    constexpr hn::RebindToUnsigned<Reals> words{};
    constexpr hn::Rebind<std::uint32_t, Reals> halves{};
    hn::Store(hn::TruncateTo(halves, hn::BitCast(words, sum)), halves, to);
}

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
