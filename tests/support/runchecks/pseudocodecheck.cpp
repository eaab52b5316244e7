// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"
#include "tests/support/runchecks/runcheck.h"

#include <QStringList>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace pixelplumb {

namespace {

/// All steps of a scene's run in the method's first arithmetic; some steps of other runs.
std::vector<std::size_t> stepsToLookAt(const CheckedRun &run)
{
    std::vector<std::size_t> steps;
    const TracedScene &traced = *run.traced;
    if (run.origin == RunOrigin::Scene
        && traced.scene.settings.arithmetic == traced.method->arithmetics.front()) {
        steps.resize(traced.trace->stepCount());
        std::iota(steps.begin(), steps.end(), std::size_t(0));
    } else {
        for (const ExplainedStep &each : run.steps)
            steps.push_back(each.index);
    }
    return steps;
}

/// The first step that no line lists; empty if there is none. Adds the texts of the lines that are
/// done to `done`.
QString faultOf(const CheckedRun &run, std::set<QString> &done)
{
    const ScanTrace &trace = *run.traced->trace;
    std::map<std::size_t, Pseudocode> codes;
    for (const std::size_t index : stepsToLookAt(run)) {
        const std::size_t primitive = trace.stepAt(index).primitive;
        const Pseudocode &code
            = codes.try_emplace(primitive, pseudocodeOf(*run.traced, primitive)).first->second;
        const Moment moment = momentOf(trace, index);
        bool isListed = false;
        for (const PseudocodeLine &line : code) {
            if (std::ranges::find(line.moments, moment) == line.moments.end())
                continue;
            isListed = true;
            if (run.origin == RunOrigin::Scene && !run.traced->shading())
                done.insert(line.text);
        }
        if (!isListed)
            return u"no line lists the moment %1 of step %2"_s.arg(int(moment)).arg(index);
    }
    return {};
}

QString faultOfAll(const Method &method, const std::set<QString> &done)
{
    QStringList missing;
    for (const PseudocodeLine &line : method.pseudocode) {
        // Segments are drawn under one rule only: tst_segmentwords checks them; what a kind of
        // antialiasing does, tst_curvelistings runs. A line without a text is another rule's.
        if (line.of != LineOf::Segment && line.antialiasing.empty() && !line.text.isEmpty()
            && !done.contains(line.text))
            missing += line.text;
    }
    return missing.isEmpty() ? QString() : u"never done: "_s + missing.join(u"; "_s);
}

} // namespace

RunCheck pseudocodeCheck()
{
    const auto done = std::make_shared<std::set<QString>>();
    return {u"every step does a line of the pseudocode, and every line is done"_s,
            [done](const CheckedRun &run) { return faultOf(run, *done); },
            [done](const Method &method) { return faultOfAll(method, *done); }};
}

} // namespace pixelplumb
