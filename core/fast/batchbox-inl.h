// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding boxes of a vector of triangles. Compiled once for each instruction set.
#include "core/fast/pixelvectors-inl.h"
#include "core/fast/trianglebatch.h"
#include "core/scan/scansettings.h"

#if defined(PIXELPLUMB_BATCHBOX_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BATCHBOX_INL
#undef PIXELPLUMB_BATCHBOX_INL
#else
#define PIXELPLUMB_BATCHBOX_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The samples ⌈c⌉ … ⌊d⌋ of a vector of triangles, or … ⌈d⌉ − 1 under the half-open rule, clipped
/// to the window and stored in the batch, and what the rest of the set-up needs to know about them.
template <FillRule Rule, class Reals>
struct BatchBox {
    using Real = hn::Vec<Reals>;
    using Mask = hn::Mask<Reals>;

    Real column; ///< first sample, px
    Real row;
    Real steps; ///< n + 1, or more: width + height
    Mask isEmpty; ///< no sample
    Mask isSmall; ///< as far as the box alone shows
    Mask isNarrow; ///< at most 8 columns
    Mask isBeyondStrip; ///< wider than 16 columns
    /// At least four times as wide as high, unclipped: a low window would make any triangle so.
    Mask isWide;

    HWY_INLINE BatchBox(TriangleBatch &batch, std::size_t i, std::int32_t windowWidth,
                        std::int32_t windowHeight)
    {
        const auto corner = [i](const TriangleBatch::Array<std::int32_t> &array)
                                HWY_ATTR { return hn::Load(integers, array.data() + i); };
        const auto least = [&](const TriangleBatch::PerCorner<std::int32_t> &c) HWY_ATTR {
            return hn::Min(hn::Min(corner(c[0]), corner(c[1])), corner(c[2]));
        };
        const auto greatest = [&](const TriangleBatch::PerCorner<std::int32_t> &c) HWY_ATTR {
            return hn::Max(hn::Max(corner(c[0]), corner(c[1])), corner(c[2]));
        };
        const auto firstSample = [](Integer lattice) HWY_ATTR {
            const Integer up = hn::Add(lattice, hn::Set(integers, 255));
            return hn::Max(hn::ShiftRight<8>(up), hn::Zero(integers));
        };
        const auto endSample = [](Integer lattice, std::int32_t limit) HWY_ATTR {
            const Integer next
                = hn::Add(lattice, hn::Set(integers, Rule == FillRule::Closed ? 256 : 255));
            return hn::Min(hn::ShiftRight<8>(next), hn::Set(integers, limit));
        };
        const Integer left = least(batch.x);
        const Integer right = greatest(batch.x);
        const Integer bottom = least(batch.y);
        const Integer top = greatest(batch.y);
        const Integer firstColumn = firstSample(left);
        const Integer firstRow = firstSample(bottom);
        const Integer endColumn = endSample(right, windowWidth);
        const Integer endRow = endSample(top, windowHeight);
        hn::Store(firstColumn, integers, batch.firstColumn.data() + i);
        hn::Store(endColumn, integers, batch.endColumn.data() + i);
        hn::Store(firstRow, integers, batch.firstRow.data() + i);
        hn::Store(endRow, integers, batch.endRow.data() + i);
        const Integer wholeWidth = hn::Sub(right, left);
        const Integer wholeHeight = hn::Sub(top, bottom);
        const Integer extent = hn::Max(wholeWidth, wholeHeight);
        hn::Store(extent, integers, batch.extent.data() + i);
        const Real width = numbersOf(reals, hn::Sub(endColumn, firstColumn));
        const Real height = numbersOf(reals, hn::Sub(endRow, firstRow));
        const auto holdsSamples = hn::Gt(hn::Min(width, height), real(0));
        const auto fits
            = hn::And(hn::Le(width, real(TriangleBatch::blockColumns)),
                      hn::Lt(numbersOf(reals, extent), real(TriangleBatch::blockExtent + 0.5)));
        column = numbersOf(reals, firstColumn);
        row = numbersOf(reals, firstRow);
        steps = hn::Add(width, height);
        isEmpty = hn::Not(holdsSamples);
        isSmall = hn::And(holdsSamples, fits);
        isNarrow = hn::Le(width, real(8));
        isBeyondStrip = hn::Gt(width, real(16));
        isWide
            = hn::Ge(numbersOf(reals, wholeWidth), hn::Mul(numbersOf(reals, wholeHeight), real(4)));
    }

private:
    using Integers = hn::Rebind<std::int32_t, Reals>;
    using Integer = hn::Vec<Integers>;
    static constexpr Reals reals{};
    static constexpr Integers integers{};

    static Real real(double value) { return hn::Set(reals, hn::TFromD<Reals>(value)); }
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
