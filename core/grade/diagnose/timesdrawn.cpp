// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/timesdrawn.h"

#include "core/grade/rounding/samplechoices.h"

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

/// "not drawn", "drawn once", "drawn twice", "drawn 3 times"
QString timesText(std::size_t times)
{
    switch (times) {
    case 0:
        return u"not drawn"_s;
    case 1:
        return u"drawn once"_s;
    case 2:
        return u"drawn twice"_s;
    default:
        return u"drawn %1 times"_s.arg(times);
    }
}

} // namespace

std::optional<QString> notDrawnOnce(const ProgramTrace &trace, const TracedScene &run,
                                    const Margin &margin)
{
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> times;
    for (const WrittenLine &line : trace.lines)
        times[{line.x, line.y}] += line.axis ? 0 : 1;
    const FrameSpec &frame = run.scene.frame;
    const std::vector<std::uint8_t> all(std::size_t(frame.width) * std::size_t(frame.height), 1);
    for (const SampleChoice &choice :
         sampleChoicesOf(run.primitives.triangles, run.scene, margin, all)) {
        if (choice.isDecided())
            continue; // compared already
        const auto sets = choice.sets(margin.leeway);
        const auto [least, most]
            = std::ranges::minmax_element(sets, {}, &std::vector<std::size_t>::size);
        const std::size_t is = times[{choice.x(), choice.y()}];
        if (is >= least->size() && is <= most->size())
            continue;
        const bool isTooOften = is > most->size();
        QString should = timesText(isTooOften ? most->size() : least->size());
        if (least->size() < most->size())
            should += isTooOften ? u" at most"_s : u" at least"_s;
        return u"pixel (%1, %2) lies on an edge that triangles share: %3, should be %4"_s
            .arg(choice.x())
            .arg(choice.y())
            .arg(timesText(is), should);
    }
    return std::nullopt;
}

} // namespace pixelplumb
