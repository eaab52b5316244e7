// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a few columns and rows. Compiled once for each instruction set.
#include "core/fast/pixelvectors-inl.h"
#include "core/fast/trianglebatch.h"

#if defined(PIXELPLUMB_BLOCKSCAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_BLOCKSCAN_INL
#undef PIXELPLUMB_BLOCKSCAN_INL
#else
#define PIXELPLUMB_BLOCKSCAN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

enum class Shading { Flat, Smooth };

/// A triangle whose box has at most `Columns` columns: the set-up's edge functions and colours in
/// all columns of a row at once, one addition a row each. A sample is inside where none of the
/// three edge functions is negative, that is, where their bitwise or is not.
template <int Columns, Shading S>
HWY_INLINE void drawBlock(const TriangleBatch &batch, std::size_t i, FrameView window)
{
    using D = Pixels<Columns>;
    constexpr D d{};
    const hn::RebindToSigned<D> di{};
    constexpr int lanes = lanesOf<D>;

    // A block at the right end of the window begins further left, over columns that are outside.
    const std::int32_t firstColumn
        = HWY_MIN(batch.firstColumn[i], window.width - std::int32_t(Columns));
    const std::int32_t rows = batch.endRow[i] - batch.firstRow[i];
    for (int group = 0; group < Columns / lanes; ++group) {
        const std::int32_t column = firstColumn + group * lanes;
        if (column >= batch.endColumn[i])
            break;
        const std::int32_t shift = column - batch.firstColumn[i];
        const auto places = countFrom(di, shift);
        const auto edgeAt = [&](std::size_t edge) HWY_ATTR {
            return hn::Add(hn::Set(di, batch.edge[edge][i]),
                           hn::Mul(places, hn::Set(di, batch.edgePerColumn[edge][i])));
        };
        const auto wordAt = [&](std::size_t channel) HWY_ATTR {
            const auto perColumn = hn::Set(d, std::uint32_t(batch.perColumn[channel][i] >> 32));
            return hn::Add(hn::Set(d, std::uint32_t(batch.start[channel][i] >> 32)),
                           hn::Mul(hn::BitCast(d, places), perColumn));
        };
        auto edge0 = edgeAt(0);
        auto edge1 = edgeAt(1);
        auto edge2 = edgeAt(2);
        const auto edge0PerRow = hn::Set(di, batch.edgePerRow[0][i]);
        const auto edge1PerRow = hn::Set(di, batch.edgePerRow[1][i]);
        const auto edge2PerRow = hn::Set(di, batch.edgePerRow[2][i]);
        auto red = wordAt(0);
        auto green = wordAt(1);
        auto blue = wordAt(2);
        const auto redPerRow = hn::Set(d, std::uint32_t(batch.perRow[0][i] >> 32));
        const auto greenPerRow = hn::Set(d, std::uint32_t(batch.perRow[1][i] >> 32));
        const auto bluePerRow = hn::Set(d, std::uint32_t(batch.perRow[2][i] >> 32));
        const auto flat = hn::Set(d, packed(batch.source[i].vertices[0].colour));

        QRgb *to = window.base + batch.firstRow[i] * window.stride + column;
        for (std::int32_t row = 0; row < rows; ++row) {
            const auto inside = hn::Gt(hn::Or3(edge0, edge1, edge2), hn::Set(di, -1));
            const auto pixels = S == Shading::Flat ? flat : pixelsOf(d, red, green, blue);
            storeWhere(d, hn::RebindMask(d, inside), pixels, to);
            to += window.stride;
            edge0 = hn::Add(edge0, edge0PerRow);
            edge1 = hn::Add(edge1, edge1PerRow);
            edge2 = hn::Add(edge2, edge2PerRow);
            if constexpr (S == Shading::Smooth) {
                red = hn::Add(red, redPerRow);
                green = hn::Add(green, greenPerRow);
                blue = hn::Add(blue, bluePerRow);
            }
        }
    }
}

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
