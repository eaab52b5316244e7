// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/oracle.h"
#include "core/trace/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Where the exact run is at the same place as a span of the trace.
std::optional<std::size_t> twinOf(const TracedScene &traced, std::size_t span)
{
    if (!traced.exactTrace)
        return std::nullopt;
    const std::size_t primitive = traced.trace->primitiveOf(span);
    if (primitive >= traced.exactTrace->primitiveCount())
        return std::nullopt;
    const SpanPlace &place = traced.trace->placeOf(span);
    return traced.exactTrace->spanOn(primitive, place.axis, place.coordinate);
}

} // namespace

std::vector<Quantity> exactSpanCells(const TracedScene &traced, std::size_t span)
{
    if (traced.method->exactSpan)
        return traced.method->exactSpan(traced, span);
    const std::vector<TraceColumn> &columns = traced.method->spanColumns;
    std::vector<Quantity> cells(columns.size());
    const std::optional<std::size_t> twin = twinOf(traced, span);
    const bool isExact = traced.scene.settings.arithmetic == Arithmetic::Exact;
    if (!twin && !isExact)
        return cells;
    const std::vector<Quantity> exact
        = twin ? traced.exactTrace->span(*twin).cells : traced.trace->span(span).cells;
    for (std::size_t i = 0; i < std::min(exact.size(), cells.size()); ++i) {
        if (columns[i].comparison == Comparison::WithExact)
            cells[i] = exact[i];
    }
    return cells;
}

ExactSample exactSampleOf(const TracedScene &traced, std::size_t span, const SampleRecord &sample)
{
    ExactSample exact;
    const std::vector<TraceColumn> &columns = traced.method->sampleColumns;
    exact.cells.resize(columns.size());
    const std::size_t primitive = traced.trace->primitiveOf(span);
    if (traced.primitives.isTriangle(primitive))
        exact.colour = oracle::colourAt(traced.primitives.triangles[primitive], sample.x, sample.y);
    const bool isExact = traced.scene.settings.arithmetic == Arithmetic::Exact;
    std::vector<Quantity> cells = isExact ? sample.cells : std::vector<Quantity>();
    if (const std::optional<std::size_t> twin = twinOf(traced, span)) {
        for (const SampleRecord &other : traced.exactTrace->samples(*twin)) {
            if (other.x == sample.x && other.y == sample.y)
                cells = other.cells;
        }
    }
    for (std::size_t i = 0; i < std::min(cells.size(), exact.cells.size()); ++i) {
        if (columns[i].comparison == Comparison::WithExact)
            exact.cells[i] = cells[i];
    }
    return exact;
}

} // namespace pixelplumb
