// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/constantnumbers.h"

#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether any span in [first, end) has the cell.
std::vector<bool> isThereIn(const ScanTrace &trace, std::size_t first, std::size_t end)
{
    std::vector<bool> isThere(trace.numbers().span.size(), false);
    for (std::size_t span = first; span < end; ++span) {
        const std::vector<Quantity> cells = trace.span(span).cells;
        bool areAll = true;
        for (std::size_t i = 0; i < isThere.size(); ++i) {
            isThere[i] = isThere[i] || (i < cells.size() && !cells[i].isNone());
            areAll = areAll && isThere[i];
        }
        if (areAll)
            break;
    }
    return isThere;
}

/// Keeps only those that have one value in the primitive's spans.
void keepConstant(std::vector<bool> &candidates, const ScanTrace &trace, std::size_t primitive)
{
    std::vector<Quantity> values(candidates.size());
    const std::size_t end = trace.endSpanOf(primitive);
    for (std::size_t span = trace.firstSpanOf(primitive); span < end; ++span) {
        if (std::find(candidates.begin(), candidates.end(), true) == candidates.end())
            return;
        const std::vector<Quantity> cells = trace.span(span).cells;
        for (std::size_t i = 0; i < std::min(candidates.size(), cells.size()); ++i) {
            if (!candidates[i] || cells[i].isNone())
                continue;
            if (values[i].isNone())
                values[i] = cells[i];
            candidates[i] = cells[i] == values[i];
        }
    }
}

} // namespace

std::vector<bool> constantNumbersBefore(const TracedScene &traced, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t primitive = trace.primitiveOf(span);
    std::vector<bool> constant = isThereIn(trace, trace.firstSpanOf(primitive), span);
    const bool hasTwin = traced.exactTrace && primitive < traced.exactTrace->primitiveCount();
    keepConstant(constant, hasTwin ? *traced.exactTrace : trace, primitive);
    return constant;
}

} // namespace pixelplumb
