// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/scantrace.h"

#include <algorithm>

namespace pixelplumb {

TraceStep ScanTrace::stepAt(std::size_t index) const
{
    Q_ASSERT(index < stepCount());
    TraceStep step;
    const auto triangle
        = std::ranges::upper_bound(m_triangles, index, {}, &TriangleEntry::step) - 1;
    step.triangle = std::size_t(triangle - m_triangles.begin());
    if (triangle->step == index)
        return step;
    const auto column = std::ranges::upper_bound(m_columns, index, {}, &ColumnEntry::step) - 1;
    step.column = std::size_t(column - m_columns.begin());
    step.kind = column->step == index ? StepKind::Column : StepKind::Pixel;
    if (step.kind == StepKind::Pixel)
        step.pixel = column->firstPixel + (index - column->step - 1);
    return step;
}

std::size_t ScanTrace::indexOfPixel(std::size_t pixel) const
{
    const ColumnEntry &column = m_columns[columnOf(pixel)];
    return column.step + 1 + (pixel - column.firstPixel);
}

std::size_t ScanTrace::pixelsDoneAt(std::size_t position) const
{
    const auto next = std::ranges::lower_bound(m_columns, position, {}, &ColumnEntry::step);
    if (next == m_columns.begin())
        return 0;
    const auto column = next - 1;
    const std::size_t pixelsOfColumn
        = endPixelOf(std::size_t(column - m_columns.begin())) - column->firstPixel;
    return column->firstPixel + std::min(pixelsOfColumn, position - column->step - 1);
}

std::size_t ScanTrace::endColumnOf(std::size_t triangle) const
{
    return triangle + 1 < m_triangles.size() ? m_triangles[triangle + 1].firstColumn
                                             : m_columns.size();
}

std::size_t ScanTrace::endPixelOf(std::size_t column) const
{
    return column + 1 < m_columns.size() ? m_columns[column + 1].firstPixel : m_pixels.size();
}

std::size_t ScanTrace::triangleOf(std::size_t column) const { return m_columns[column].triangle; }

std::size_t ScanTrace::columnOf(std::size_t pixel) const
{
    // The last column that starts at or before the pixel: empty columns share their successor's
    // start.
    const auto next = std::ranges::upper_bound(m_columns, pixel, {}, &ColumnEntry::firstPixel);
    return std::size_t(next - m_columns.begin()) - 1;
}

} // namespace pixelplumb
