// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/fastkernels.h"
#include "core/scan/walks/columnscan.h"

namespace pixelplumb {

/// Gathers the columns of a float32 scan into strips, which are coloured sixteen columns at a time.
class FloatColumns {
public:
    FloatColumns(const FastKernels &kernels, FrameView window)
        : m_kernels(kernels)
        , m_window(window)
    {
        clear();
    }

    void take(const ColumnState<RoundedArithmetic<float>> &column, ByteRounding rounding)
    {
        m_rounding = rounding;
        const auto place = std::int32_t(column.x - m_window.firstColumn);
        if (m_isEmpty || place >= m_strip.firstColumn + FloatStrip::columns) {
            flush();
            m_strip.firstColumn = stripAt(place);
            m_isEmpty = false;
        }
        const auto lane = std::size_t(place - m_strip.firstColumn);
        m_strip.firstRow[lane] = std::int32_t(column.firstDrawn - m_window.firstRow);
        m_strip.endRow[lane] = std::int32_t(column.endDrawn - m_window.firstRow);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            m_strip.colour[channel][lane] = column.firstColour[channel];
            m_strip.rate[channel][lane] = column.colourRate[channel];
        }
    }

    /// Draws the gathered columns; to be called after the last column of a triangle.
    void flush()
    {
        if (!m_isEmpty)
            m_kernels.drawFloatStrip(m_strip, m_rounding, m_window);
        clear();
    }

private:
    /// Aligns a strip to a cache line where the window allows it.
    std::int32_t stripAt(std::int32_t place) const
    {
        const auto address = reinterpret_cast<std::uintptr_t>(m_window.base + place);
        const std::int32_t aligned = place - std::int32_t(address / sizeof(QRgb) % 16);
        return std::clamp(aligned, 0, m_window.width - FloatStrip::columns);
    }

    void clear()
    {
        m_isEmpty = true;
        m_strip.firstRow.fill(FloatStrip::never);
        m_strip.endRow.fill(0);
    }

    const FastKernels &m_kernels;
    FrameView m_window;
    ByteRounding m_rounding = ByteRounding::Nearest;
    FloatStrip m_strip;
    bool m_isEmpty = true;
};

/// An observer that ignores all events; it makes fillColumn() hand the column over.
struct FloatColumnTaker : NullObserver {
    FloatColumns *columns = nullptr;
};

/// It takes only what the picture needs.
template <>
inline constexpr bool readsNumbers<FloatColumnTaker> = false;

/// Replaces the plain fillColumn(): ColumnScan selects it by its observer, so everything up to the
/// column's first colour is the plain kernel's own code, with its roundings.
inline void fillColumn(const ColumnState<RoundedArithmetic<float>> &column, ByteRounding rounding,
                       FrameView, FloatColumnTaker taker)
{
    if (column.firstDrawn < column.endDrawn)
        taker.columns->take(column, rounding);
}

inline void drawFloatTriangle(const Triangle &triangle, const ScanSettings &settings,
                              FrameView window, const FastKernels &kernels)
{
    FloatColumns columns(kernels, window);
    FloatColumnTaker taker;
    taker.columns = &columns;
    ColumnScan<RoundedArithmetic<float>, FloatColumnTaker>(
        triangle, columnIntervals(settings.fillRule), settings.rounding, window, taker)
        .run();
    columns.flush();
}

} // namespace pixelplumb
