// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/oracle/oracle.h"
#include "core/scan/walks/columnscan.h"

#include <vector>

namespace pixelplumb::search {

/// Counts the pixels whose levels had to be clamped.
template <class A>
struct ClampCounter {
    std::int64_t *clamped;

    void primitiveBegun(const ColumnSetUp<A> &) { }
    void primitiveRejected(const Rejection &) { }
    void spanEntered(const ColumnState<A> &) { }
    void sampleRejected(std::int64_t, std::int64_t, QRgb, const Fragment<A> &) { }
    void pixelWritten(std::int64_t, std::int64_t, QRgb, QRgb, const Fragment<A> &fragment)
    {
        *clamped += fragment.isClamped() ? 1 : 0;
    }
};

/// One triangle on an empty canvas: 0 (alpha 0) where nothing was written. Rows count upward from
/// the canvas' first row. It is plain memory, because a search draws millions of pictures.
class CanvasPicture {
public:
    explicit CanvasPicture(const FrameSpec &canvas)
        : m_canvas(canvas)
        , m_pixels(std::size_t(canvas.width) * std::size_t(canvas.height), QRgb(0))
    {
    }

    void drawTruly(const Triangle &triangle, FillRule rule,
                   ByteRounding rounding = ByteRounding::Nearest)
    {
        oracle::draw(triangle, rule, rounding, view());
    }
    /// Returns the number of clamped pixels.
    std::int64_t drawByScan(const Triangle &triangle, const ScanSettings &settings)
    {
        switch (settings.arithmetic) {
        case Arithmetic::Exact:
            return integerWidthFor(triangle) == IntegerWidth::Bits64
                ? scan<ExactArithmetic<std::int64_t>>(triangle, settings)
                : scan<ExactArithmetic<Int128>>(triangle, settings);
        case Arithmetic::Float32:
            return scan<RoundedArithmetic<float>>(triangle, settings);
        case Arithmetic::Float64:
            return scan<RoundedArithmetic<double>>(triangle, settings);
        case Arithmetic::Fixed16:
            return scan<RoundedArithmetic<FixedPoint16>>(triangle, settings);
        case Arithmetic::Fixed32:
            return scan<RoundedArithmetic<FixedPoint32>>(triangle, settings);
        }
        return 0;
    }

    FrameView view()
    {
        return {m_pixels.data(),   m_canvas.width, m_canvas.firstColumn,
                m_canvas.firstRow, m_canvas.width, m_canvas.height};
    }

    const FrameSpec &canvas() const { return m_canvas; }
    const std::vector<QRgb> &pixels() const { return m_pixels; }
    /// The number of written pixels.
    std::int64_t count() const
    {
        return std::ranges::count_if(m_pixels, [](QRgb pixel) { return pixel != 0; });
    }

private:
    template <class A>
    std::int64_t scan(const Triangle &triangle, const ScanSettings &settings)
    {
        using Counter = ClampCounter<A>;
        std::int64_t clamped = 0;
        ColumnScan<A, Counter>(triangle, columnIntervals(settings.fillRule), settings.rounding,
                               view(), Counter{&clamped})
            .run();
        return clamped;
    }

    FrameSpec m_canvas;
    std::vector<QRgb> m_pixels;
};

} // namespace pixelplumb::search
