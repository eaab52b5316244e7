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
            return u"step %1"_s.arg(each.index);
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
            return u"span %1 has “%2”, the first “%3”"_s.arg(span).arg(here.join(u' '),
                                                                       titles.join(u' '));
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
            if (rounds && !number.formula.endsWith(u" = "_s + number.title))
                return u"“%1” is “%2”"_s.arg(number.title, number.formula);
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
        if (each.explanation.sentence.contains(u"tested one by one"_s))
            return each.explanation.sentence;
    }
    return {};
}

QString centreFault(const CheckedRun &run)
{
    const bool isHalf = run.traced->scene.frame.pixelCentre == PixelCentre::Half;
    for (const ExplainedStep &each : run.steps) {
        if (each.step.kind == StepKind::SetUp
            && each.explanation.sentence.contains(u"½ px less than the scene's"_s) != isHalf)
            return each.explanation.sentence;
    }
    return {};
}

} // namespace

std::vector<RunCheck> wordChecks()
{
    return {{u"every step has a heading and a sentence"_s, sentenceFault},
            {u"titles follow the settings alone"_s, titleFault},
            {u"a heading that rounds is the formula"_s, roundingFault},
            {u"only methods that test samples say so"_s, testedFault},
            {u"coordinates that are not the scene's are said to be"_s, centreFault}};
}

} // namespace pixelplumb
