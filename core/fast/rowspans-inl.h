// SPDX-License-Identifier: GPL-3.0-or-later
// Draws by spans of rows the same samples as strips. Compiled once for each instruction set.
#include "core/fast/spans-inl.h"

#if defined(PIXELPLUMB_ROWSPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELPLUMB_ROWSPANS_INL
#undef PIXELPLUMB_ROWSPANS_INL
#else
#define PIXELPLUMB_ROWSPANS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelplumb::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// For wide flat boxes: a strip would be all masked stores, a row is one run of stores. The spans
/// of 16 rows are computed at once.
template <class Colour, class D>
class RowSpanScan {
    static constexpr int lanes = lanesOf<D>;
    static constexpr int rowsAtOnce = 16;
    static constexpr D d{};
    static constexpr hn::RebindToSigned<D> di{};

public:
    /// Parameters as for StripScan.
    RowSpanScan(const FrameView &window, const BoundingLines &lines, const SampleBox &box,
                std::int32_t originColumn, std::int32_t originRow)
        : m_window(window)
        , m_lines(lines)
        , m_box(box)
        , m_originColumn(originColumn)
        , m_originRow(originRow)
    {
    }

    HWY_INLINE void run(const Colour &colour) const
    {
        Spans<rowsAtOnce> spans;
        for (std::int32_t first = m_box.firstRow; first < m_box.endRow; first += rowsAtOnce) {
            spans.compute(m_lines, first, {m_box.firstRow, m_box.endRow},
                          {m_box.firstColumn, m_box.endColumn});
            const std::int32_t rows = HWY_MIN(std::int32_t(rowsAtOnce), m_box.endRow - first);
            for (std::int32_t k = 0; k < rows; ++k) {
                if (spans.first[std::size_t(k)] < spans.end[std::size_t(k)])
                    scanRow(colour, first + k, spans.first[std::size_t(k)],
                            spans.end[std::size_t(k)]);
            }
        }
    }

private:
    HWY_INLINE void scanRow(const Colour &colour, std::int32_t row, std::int32_t first,
                            std::int32_t end) const
    {
        QRgb *const line = m_window.base + row * m_window.stride;
        const std::int32_t furthest = m_window.width - lanes;
        // Whole cache lines where the window has them.
        const auto address = reinterpret_cast<std::uintptr_t>(line + first);
        std::int32_t column = first - std::int32_t(address / sizeof(QRgb) % lanes);
        if (column < 0)
            column = first;
        column = HWY_MIN(column, furthest);
        auto state = colour.begin(column - m_originColumn, row - m_originRow);
        if (column < first || column + lanes > end) {
            storeSpan(colour.pixels(state), line, column, first, end);
            colour.advance(state);
            column += lanes;
        }
        for (; column + lanes <= end; column += lanes) {
            hn::StoreU(colour.pixels(state), d, line + column);
            colour.advance(state);
        }
        if (column < end) {
            if (column > furthest) {
                column = furthest;
                state = colour.begin(column - m_originColumn, row - m_originRow);
            }
            storeSpan(colour.pixels(state), line, column, first, end);
        }
    }

    /// Stores the pixels of one vector that lie in [first, end).
    HWY_INLINE static void storeSpan(hn::Vec<D> pixels, QRgb *line, std::int32_t column,
                                     std::int32_t first, std::int32_t end)
    {
        const auto place = countFrom(di, column);
        const auto covered
            = hn::AndNot(hn::Lt(place, hn::Set(di, first)), hn::Lt(place, hn::Set(di, end)));
        storeWhere(d, hn::RebindMask(d, covered), pixels, line + column);
    }

    const FrameView &m_window;
    const BoundingLines &m_lines;
    SampleBox m_box;
    std::int32_t m_originColumn;
    std::int32_t m_originRow;
};

} // namespace pixelplumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
