// SPDX-License-Identifier: GPL-3.0-or-later
// Draws triangles of a few columns and rows. Compiled once for each instruction set.
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

/// Which columns the lanes of a block represent, and where they are stored.
template <class D>
class BlockLanes {
    static constexpr D d{};
    static constexpr hn::RebindToSigned<D> di{};
    static constexpr std::int32_t lanes = lanesOf<D>;
    using Integer = hn::Vec<hn::RebindToSigned<D>>;
    using Mask = hn::Mask<hn::RebindToSigned<D>>;

public:
    /// True where stores have masks and vectors are as wide as a cache line: lane k is the k-th
    /// pixel of a line, the one with `column` or the next. A store across two lines costs as much
    /// as two, and fetches both even if all its pixels are in one.
    static constexpr bool areOfLines = hasMaskedStores && lanes == 16;

    /// Lanes for `column` and those after it, or from before it where the window ends.
    HWY_INLINE BlockLanes(const TriangleBatch &batch, std::size_t i, std::int32_t column,
                          const FrameView &window)
    {
        if constexpr (areOfLines) {
            m_to = window.base + batch.firstRow[i] * window.stride + column;
            const auto place
                = std::int32_t(reinterpret_cast<std::uintptr_t>(m_to) / sizeof(QRgb) % lanes);
            m_to -= place;
            const auto fromColumn = hn::And(countFrom(di, -place), hn::Set(di, lanes - 1));
            m_places = hn::Add(fromColumn, hn::Set(di, column - batch.firstColumn[i]));
            m_isInNextLine = hn::Lt(hn::Iota(di, 0), hn::Set(di, place));
            m_reachesNextLine = place + batch.endColumn[i] - column > lanes;
        } else {
            column = HWY_MIN(column, window.width - lanes);
            m_to = window.base + batch.firstRow[i] * window.stride + column;
            m_places = countFrom(di, column - batch.firstColumn[i]);
        }
    }

    /// Counted from the first column of the box.
    HWY_INLINE Integer places() const { return m_places; }
    HWY_INLINE bool reachesNextLine() const { return m_reachesNextLine; }
    HWY_INLINE void climb(std::ptrdiff_t stride) { m_to += stride; }

    template <bool ReachesNextLine>
    HWY_INLINE void store(Mask inside, hn::Vec<D> pixels) const
    {
        if constexpr (ReachesNextLine) {
            const auto here = hn::AndNot(m_isInNextLine, inside);
            const auto next = hn::And(m_isInNextLine, inside);
            storeWhere(d, hn::RebindMask(d, here), pixels, m_to);
            storeWhere(d, hn::RebindMask(d, next), pixels, m_to + lanes);
        } else {
            storeWhere(d, hn::RebindMask(d, inside), pixels, m_to);
        }
    }

private:
    QRgb *m_to;
    Integer m_places;
    Mask m_isInNextLine;
    bool m_reachesNextLine = false;
};

/// Draws a triangle whose box has few columns, `Columns` at a time: the set-up's edge functions and
/// colours in all columns of a row at once, with one addition each per row. A sample is inside
/// where none of the three edge functions is negative, that is, where their bitwise or is not.
template <int Columns, Shading S>
HWY_INLINE void drawBlock(const TriangleBatch &batch, std::size_t i, FrameView window)
{
    using D = Pixels<Columns>;
    constexpr D d{};
    const hn::RebindToSigned<D> di{};
    const std::int32_t rows = batch.endRow[i] - batch.firstRow[i];
    for (std::int32_t column = batch.firstColumn[i]; column < batch.endColumn[i];
         column += lanesOf<D>) {
        BlockLanes<D> block(batch, i, column, window);
        const auto places = block.places();
        const auto edgeAt = [&](std::size_t edge) HWY_ATTR {
            return hn::Add(hn::Set(di, batch.edge[edge][i]),
                           hn::Mul(places, hn::Set(di, batch.edgePerColumn[edge][i])));
        };
        const auto wordAt = [&](std::size_t channel) HWY_ATTR {
            const auto perColumn = hn::Set(d, batch.narrowPerColumn[channel][i]);
            return hn::Add(hn::Set(d, batch.narrowStart[channel][i]),
                           hn::Mul(hn::BitCast(d, places), perColumn));
        };
        auto edge0 = edgeAt(0);
        auto edge1 = edgeAt(1);
        auto edge2 = edgeAt(2);
        if constexpr (BlockLanes<D>::areOfLines) {
            // Right of the box, where a clipped triangle continues, edge 0 stays negative in every
            // row.
            const auto count = hn::Set(di, batch.endColumn[i] - batch.firstColumn[i]);
            edge0 = hn::IfThenElse(hn::Lt(places, count), edge0, hn::Set(di, -(1 << 30)));
        }
        const auto edge0PerRow = hn::Set(di, batch.edgePerRow[0][i]);
        const auto edge1PerRow = hn::Set(di, batch.edgePerRow[1][i]);
        const auto edge2PerRow = hn::Set(di, batch.edgePerRow[2][i]);
        auto red = wordAt(0);
        auto green = wordAt(1);
        auto blue = wordAt(2);
        const auto redPerRow = hn::Set(d, batch.narrowPerRow[0][i]);
        const auto greenPerRow = hn::Set(d, batch.narrowPerRow[1][i]);
        const auto bluePerRow = hn::Set(d, batch.narrowPerRow[2][i]);
        const auto flat = hn::Set(d, packed(batch.source[i].vertices[0].colour));

        const auto scan = [&](auto reachesNextLine) HWY_ATTR {
            for (std::int32_t row = 0; row < rows; ++row) {
                const auto inside = hn::Gt(hn::Or3(edge0, edge1, edge2), hn::Set(di, -1));
                const auto pixels = S == Shading::Flat ? flat : pixelsOf(d, red, green, blue);
                block.template store<decltype(reachesNextLine)::value>(inside, pixels);
                block.climb(window.stride);
                edge0 = hn::Add(edge0, edge0PerRow);
                edge1 = hn::Add(edge1, edge1PerRow);
                edge2 = hn::Add(edge2, edge2PerRow);
                if constexpr (S == Shading::Smooth) {
                    red = hn::Add(red, redPerRow);
                    green = hn::Add(green, greenPerRow);
                    blue = hn::Add(blue, bluePerRow);
                }
            }
        };
        if (block.reachesNextLine())
            scan(std::bool_constant<BlockLanes<D>::areOfLines>());
        else
            scan(std::false_type());
    }
}

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
