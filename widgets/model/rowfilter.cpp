// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/rowfilter.h"

#include "core/runs/tracedscene.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace pixelplumb {

namespace {

/// The spans with a mark; each span has one at most.
std::vector<std::size_t> markedSpans(const TracedScene &traced, MarkKind kind)
{
    std::vector<std::size_t> spans;
    for (const TraceMark &mark : traced.marks) {
        if (mark.kind == kind)
            spans.push_back(traced.trace->stepAt(mark.step).span);
    }
    return spans;
}

/// The columns and rows of the frame in which a pixel differs.
struct WrongLines {
    std::set<std::int64_t> columns;
    std::set<std::int64_t> rows;

    explicit WrongLines(const TracedScene &traced)
    {
        const FrameSpec &frame = traced.scene.frame;
        for (std::int64_t y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
            std::int64_t x = frame.firstColumn;
            for (const Difference kind : traced.differences.row(y)) {
                if (kind != Difference::None) {
                    columns.insert(x);
                    rows.insert(y);
                }
                ++x;
            }
        }
    }
};

bool isWrong(const TracedScene &traced, const WrongLines &lines, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const SpanPlace &place = trace.placeOf(span);
    switch (place.axis) {
    case SpanAxis::Column:
        return lines.columns.contains(place.coordinate);
    case SpanAxis::Row:
        return lines.rows.contains(place.coordinate);
    case SpanAxis::Free:
        break;
    }
    for (std::size_t i = trace.firstSampleOf(span); i < trace.endSampleOf(span); ++i) {
        const PixelChange &change = trace.changes()[i];
        if (traced.differences.at(change.x, change.y) != Difference::None)
            return true;
    }
    return false;
}

} // namespace

std::vector<std::size_t> spansOf(const TracedScene &traced, RowFilter filter)
{
    if (filter == RowFilter::Ties || filter == RowFilter::Clamps)
        return markedSpans(traced, filter == RowFilter::Ties ? MarkKind::Tie : MarkKind::Clamp);
    std::vector<std::size_t> spans(traced.trace->spanCount());
    std::iota(spans.begin(), spans.end(), std::size_t(0));
    if (filter == RowFilter::Errors) {
        const WrongLines lines(traced);
        std::erase_if(spans, [&](std::size_t span) { return !isWrong(traced, lines, span); });
    }
    return spans;
}

} // namespace pixelplumb
