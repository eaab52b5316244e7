// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/runcheck.h"
#include "tests/support/spread.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

/// How many spans of a run have their titles compared.
constexpr std::size_t titledSpans = 12;

QString sentenceFault(const CheckedRun &run)
{
    for (const ExplainedStep &each : run.steps) {
        if (each.explanation.heading.isEmpty() || each.explanation.sentence.isEmpty())
            return QStringLiteral("step %1").arg(each.index);
    }
    return {};
}

QString titleFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    QStringList titles;
    for (const std::size_t span : spreadOver(trace.spanCount(), titledSpans)) {
        QStringList here;
        for (const NumberDescription &number : trace.spanWords(span).numbers)
            here.append(number.title);
        if (span == 0)
            titles = here;
        else if (here != titles)
            return QStringLiteral("span %1 has “%2”, the first “%3”")
                .arg(span)
                .arg(here.join(u' '), titles.join(u' '));
    }
    return {};
}

/// A number whose title says how it is rounded is computed by just that.
QString roundingFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    for (const std::size_t span : spreadOver(trace.spanCount(), titledSpans)) {
        for (const NumberDescription &number : trace.spanWords(span).numbers) {
            const bool rounds = number.title.contains(u'⌈') || number.title.contains(u'⌊');
            if (rounds && !number.formula.endsWith(QStringLiteral(" = ") + number.title))
                return QStringLiteral("“%1” is “%2”").arg(number.title, number.formula);
        }
    }
    return {};
}

QString testedFault(const CheckedRun &run)
{
    const Method &method = *run.traced->method;
    const bool tests = method.draws(PrimitiveKind::Triangle)
        && std::ranges::find(method.numbers.sample, NumberGroup::Decision,
                             &NumberDescription::group)
            != method.numbers.sample.end();
    if (tests || run.traced->shading())
        return {};
    for (const ExplainedStep &each : run.steps) {
        if (each.explanation.sentence.contains(QStringLiteral("tested one by one")))
            return each.explanation.sentence;
    }
    return {};
}

QString centreFault(const CheckedRun &run)
{
    const bool isHalf = run.traced->scene.frame.pixelCentre == PixelCentre::Half;
    for (const ExplainedStep &each : run.steps) {
        if (each.step.kind == StepKind::SetUp
            && each.explanation.sentence.contains(QStringLiteral("½ px less than the scene's"))
                != isHalf)
            return each.explanation.sentence;
    }
    return {};
}

} // namespace

std::vector<RunCheck> wordChecks()
{
    return {{QStringLiteral("every step has a heading and a sentence"), sentenceFault},
            {QStringLiteral("titles follow the settings alone"), titleFault},
            {QStringLiteral("a heading that rounds is the formula"), roundingFault},
            {QStringLiteral("only methods that test samples say so"), testedFault},
            {QStringLiteral("coordinates that are not the scene's are said to be"), centreFault}};
}

} // namespace pixelplumb
