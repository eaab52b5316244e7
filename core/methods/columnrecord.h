// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracerecords.h"

namespace pixelplumb {

/// Where the column scan's numbers stand among the cells of its spans.
enum class ColumnCell : std::size_t {
    Triangle,
    X,
    Half,
    YBottom,
    YTop,
    FirstRow,
    LastRow,
    Pixels,
    ColourBottom, ///< R, G, B from here on
    ColourTop = ColourBottom + 3,
    ColourRate = ColourTop + 3,
    FirstColour = ColourRate + 3,
    Count = FirstColour + 3,
};

/// Where its set-up's numbers stand: the slope of each edge, then the rates [SortedEdge][channel].
enum class ColumnSetUpCell : std::size_t { Slope, ColourRate = Slope + 3, Count = ColourRate + 9 };

/// A span of the column scan by its names.
class ColumnRecord {
public:
    ColumnRecord() = default;
    explicit ColumnRecord(SpanRecord span)
        : m_span(std::move(span))
    {
    }

    const SpanRecord &span() const { return m_span; }
    std::int64_t x() const { return m_span.place.coordinate; }
    ColumnHalf half() const { return ColumnHalf(m_span.place.part); }
    Quantity yBottom() const { return m_span.lower; }
    Quantity yTop() const { return m_span.upper; }
    Quantity colourBottom(std::size_t channel) const
    {
        return cell(ColumnCell::ColourBottom, channel);
    }
    Quantity colourTop(std::size_t channel) const { return cell(ColumnCell::ColourTop, channel); }
    Quantity colourRate(std::size_t channel) const { return cell(ColumnCell::ColourRate, channel); }
    Quantity firstColour(std::size_t channel) const
    {
        return cell(ColumnCell::FirstColour, channel);
    }

private:
    Quantity cell(ColumnCell first, std::size_t channel) const
    {
        const std::size_t index = std::size_t(first) + channel;
        return index < m_span.cells.size() ? m_span.cells[index] : Quantity();
    }

    SpanRecord m_span;
};

} // namespace pixelplumb
