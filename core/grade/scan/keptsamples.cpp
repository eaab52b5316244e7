// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/keptsamples.h"

#include <algorithm>

namespace pixelplumb {

SpanGeometry::SpanGeometry(const Triangle &walked)
    : triangle(walked)
    , box(boundingBoxOf(exchanged(walked)))
{
    const auto order = sortedByColumn(walked);
    const auto at
        = [&](std::size_t place) { return walked.vertices[std::size_t(order[place])].position.x; };
    x0 = at(0);
    x1 = at(1);
    x2 = at(2);
}

Redrawing redrawingThatKeeps(const KeepsSample &keeps)
{
    return {[keeps](TriangleRuns &triangle) {
        const SpanGeometry geometry(triangle.triangle);
        std::vector<SampleRun> kept;
        for (const SampleRun &run : triangle.runs) {
            bool isOpen = false;
            for (std::int64_t place = run.first; place < run.end; ++place) {
                if (!keeps(geometry, {run.span, place, run.first, run.end - 1})) {
                    isOpen = false;
                    continue;
                }
                if (!isOpen) {
                    kept.push_back(run);
                    kept.back().first = place;
                }
                kept.back().end = place + 1;
                isOpen = true;
            }
        }
        triangle.runs = std::move(kept);
    }};
}

} // namespace pixelplumb
