// SPDX-License-Identifier: GPL-3.0-or-later
// The assignment's float32 colours in strips. Compiled once for each instruction set.
#include "core/fast/floatstrip.h"
#include "core/fast/pixelvectors-inl.h"
#include "core/scan/scansettings.h"

#if defined(PIXELPLUMB_FLOATSTRIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_FLOATSTRIP_INL
#undef PIXELPLUMB_FLOATSTRIP_INL
#else
#define PIXELPLUMB_FLOATSTRIP_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Each lane performs the plain kernel's additions in the same order, so the roundings are the
/// same: a column's colour does not change before its first row and then gains its rate every row.
class FloatStripScan {
    using D = Pixels<FloatStrip::columns>;
    using Floats = hn::RebindToFloat<D>;
    using Integers = hn::RebindToSigned<D>;
    static constexpr D d{};
    static constexpr Floats floats{};
    static constexpr Integers integers{};
    static constexpr std::size_t lanes = lanesOf<D>;
    static constexpr std::size_t vectors = FloatStrip::columns / lanes;

public:
    FloatStripScan(const FloatStrip &strip, ByteRounding rounding, FrameView window)
        : m_strip(strip)
        , m_half(rounding == ByteRounding::Nearest ? 0.5f : 0.f)
        , m_window(window)
    {
        for (std::size_t v = 0; v < vectors; ++v) {
            for (std::size_t c = 0; c < 3; ++c) {
                m_colour[c][v] = hn::Load(floats, strip.colour[c].data() + v * lanes);
                m_rate[c][v] = hn::Load(floats, strip.rate[c].data() + v * lanes);
            }
        }
    }

    void run()
    {
        std::int32_t firstRow = FloatStrip::never;
        std::int32_t firstFull = 0;
        std::int32_t endFull = FloatStrip::never;
        std::int32_t endRow = 0;
        for (std::size_t lane = 0; lane < FloatStrip::columns; ++lane) {
            firstRow = HWY_MIN(firstRow, m_strip.firstRow[lane]);
            firstFull = HWY_MAX(firstFull, m_strip.firstRow[lane]);
            endFull = HWY_MIN(endFull, m_strip.endRow[lane]);
            endRow = HWY_MAX(endRow, m_strip.endRow[lane]);
        }
        if (firstRow >= endRow)
            return;
        if (firstFull >= endFull)
            firstFull = endFull = endRow;
        m_to = m_window.base + firstRow * m_window.stride + m_strip.firstColumn;
        scanRows<true>(firstRow, firstFull);
        scanRows<false>(firstFull, endFull);
        scanRows<true>(endFull, endRow);
    }

private:
    template <bool Masked>
    HWY_INLINE void scanRows(std::int32_t firstRow, std::int32_t endRow)
    {
        for (std::int32_t row = firstRow; row < endRow; ++row) {
            for (std::size_t v = 0; v < vectors; ++v) {
                const auto pixels = pixelsOfLevels(level(m_colour[0][v]), level(m_colour[1][v]),
                                                   level(m_colour[2][v]));
                if constexpr (Masked) {
                    const auto here = hn::Set(integers, row);
                    const auto waits
                        = hn::Gt(hn::Load(integers, m_strip.firstRow.data() + v * lanes), here);
                    const auto covered = hn::AndNot(
                        waits, hn::Lt(here, hn::Load(integers, m_strip.endRow.data() + v * lanes)));
                    storeWhere(d, hn::RebindMask(d, covered), pixels, m_to + v * lanes);
                    const auto stays = hn::RebindMask(floats, waits);
                    for (std::size_t c = 0; c < 3; ++c)
                        m_colour[c][v] = hn::IfThenElse(stays, m_colour[c][v],
                                                        hn::Add(m_colour[c][v], m_rate[c][v]));
                } else {
                    hn::StoreU(pixels, d, m_to + v * lanes);
                    for (std::size_t c = 0; c < 3; ++c)
                        m_colour[c][v] = hn::Add(m_colour[c][v], m_rate[c][v]);
                }
            }
            m_to += m_window.stride;
        }
    }

    /// ⌊colour + 1/2⌋ or ⌊colour⌋, clamped to 0 … 255. Plain form: `clamp(floor(sum), 0, 255)`,
    /// where NaN gives 0; above 0 truncating is the same as floor.
    HWY_INLINE hn::Vec<D> level(hn::Vec<Floats> colour) const
    {
        const auto sum = hn::Add(colour, hn::Set(floats, m_half));
        const auto positive = hn::IfThenElseZero(hn::Gt(sum, hn::Zero(floats)), sum);
        return hn::BitCast(d, hn::ConvertTo(integers, hn::Min(positive, hn::Set(floats, 255.f))));
    }
    HWY_INLINE static hn::Vec<D> pixelsOfLevels(hn::Vec<D> red, hn::Vec<D> green, hn::Vec<D> blue)
    {
        const auto redGreen = hn::Or(hn::ShiftLeft<16>(red), hn::ShiftLeft<8>(green));
        return hn::Or3(redGreen, blue, hn::Set(d, 0xff000000u));
    }

    const FloatStrip &m_strip;
    float m_half;
    FrameView m_window;
    QRgb *m_to = nullptr;
    std::array<std::array<hn::Vec<Floats>, vectors>, 3> m_colour;
    std::array<std::array<hn::Vec<Floats>, vectors>, 3> m_rate;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
