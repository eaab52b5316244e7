// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels in the lanes of a vector. Compiled once for each instruction set.
#include "core/frame/frameview.h"

#if defined(PIXELPLUMB_PIXELVECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_PIXELVECTORS_INL
#undef PIXELPLUMB_PIXELVECTORS_INL
#else
#define PIXELPLUMB_PIXELVECTORS_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The number of lanes of a vector; known at compile time.
template <class D>
inline constexpr int lanesOf = int(hn::MaxLanes(D()));

/// A vector of at most `Columns` pixels.
template <int Columns>
using Pixels = hn::CappedTag<std::uint32_t, Columns>;

/// first, first + 1, … When Highway's own Iota(d, first) does not know `first` at compile time, it
/// stores the lanes one by one, and the load that follows waits for them all.
template <class D>
HWY_INLINE hn::Vec<D> countFrom(D d, hn::TFromD<D> first)
{
    return hn::Add(hn::Iota(d, 0), hn::Set(d, first));
}

/// Integers as doubles, or as floats, which hold them exactly up to 2^24.
template <class Reals, class Integer>
HWY_INLINE hn::Vec<Reals> numbersOf(Reals reals, Integer integers)
{
    if constexpr (sizeof(hn::TFromD<Reals>) == sizeof(std::int32_t))
        return hn::ConvertTo(reals, integers);
    else
        return hn::PromoteTo(reals, integers);
}

/// The bits of `yes` where `mask` has ones, of `no` elsewhere.
template <class D>
HWY_INLINE hn::Vec<D> selectedBits(D d, std::uint32_t mask, hn::Vec<D> yes, hn::Vec<D> no)
{
#if HWY_TARGET == HWY_SCALAR
    // On this target IfVecThenElse takes a whole lane or nothing of it.
    return hn::Or(hn::And(hn::Set(d, mask), yes), hn::AndNot(hn::Set(d, mask), no));
#else
    return hn::IfVecThenElse(hn::Set(d, mask), yes, no);
#endif
}

/// The 32-bit words 0xff'rr'gg'bb from words whose top bytes are the levels. Plain form, per lane:
/// `0xff000000 | (red >> 24) << 16 | (green >> 24) << 8 | blue >> 24`.
template <class D>
HWY_INLINE hn::Vec<D> pixelsOf(D d, hn::Vec<D> red, hn::Vec<D> green, hn::Vec<D> blue)
{
    const hn::Vec<D> opaque = hn::Set(d, 0xff000000u);
#if HWY_TARGET == HWY_AVX3_DL
    if constexpr (lanesOf<D> == 16) {
        // In lane k: byte 4k + 3 of red to place 2, byte 4k + 3 of green (64 more) to place 1.
        const auto index
            = hn::Add(hn::Set(d, 0x00034300u), hn::Mul(hn::Iota(d, 0), hn::Set(d, 0x00040400u)));
        const hn::Vec<D> redGreen{
            _mm512_maskz_permutex2var_epi8(0x6666666666666666u, red.raw, index.raw, green.raw)};
        return hn::Or3(redGreen, hn::ShiftRight<24>(blue), opaque);
    }
#endif
    const hn::Vec<D> redGreen = selectedBits(d, 0xff000000u, red, hn::ShiftRight<8>(green));
    const hn::Vec<D> all = selectedBits(d, 0xffff0000u, redGreen, hn::ShiftRight<16>(blue));
    return hn::Or(hn::ShiftRight<8>(all), opaque);
}

/// Prefetches the cache line of an address that will be written; an address outside the frame does
/// no harm.
HWY_INLINE void prefetchForStore(std::uintptr_t address)
{
    __builtin_prefetch(reinterpret_cast<const void *>(address), 1);
}

/// Whether a store can skip lanes.
inline constexpr bool hasMaskedStores = HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL;

/// Writes the lanes whose mask is set. Without masked stores the other lanes are read and written
/// back, so they must lie in memory that belongs to this thread: callers keep every vector inside
/// the window.
template <class D, class Mask>
HWY_INLINE void storeWhere(D d, Mask mask, hn::Vec<D> pixels, QRgb *to)
{
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    hn::BlendedStore(pixels, mask, d, to);
#else
    // AVX2 has masked stores, but on some processors each takes forty operations.
    hn::StoreU(hn::IfThenElse(mask, pixels, hn::LoadU(d, to)), d, to);
#endif
}

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
