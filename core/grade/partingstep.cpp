// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/methods/formulatext.h"
#include "core/runs/formulaexplanation.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

namespace {

struct StepNumbers {
    std::vector<NumberDescription> descriptions;
    std::vector<Quantity> cells;
};

StepNumbers numbersOf(const ScanTrace &trace, const TraceStep &step)
{
    switch (step.kind) {
    case StepKind::SetUp:
        return {trace.setUpWords(step.primitive).numbers, trace.setUp(step.primitive).cells};
    case StepKind::Span:
        return {trace.spanWords(step.span).numbers, trace.span(step.span).cells};
    case StepKind::Sample:
        break;
    }
    const std::size_t place = step.sample - trace.firstSampleOf(step.span);
    const std::vector<SampleRecord> samples = trace.samples(step.span);
    return {trace.sampleWords(step.span, place).numbers, samples[place].cells};
}

QString partingText(const StepNumbers &right, const StepNumbers &defective)
{
    for (std::size_t i = 0; i < right.cells.size() && i < defective.cells.size(); ++i) {
        const Quantity &should = right.cells[i];
        const Quantity &is = defective.cells[i];
        if (is == should || right.descriptions[i].id != defective.descriptions[i].id)
            continue;
        const auto text = [](const Quantity &quantity) {
            return quantity.isNone() ? QStringLiteral("not there") : term(quantity);
        };
        return QStringLiteral("%1 is %2, should be %3")
            .arg(right.descriptions[i].title, text(is), text(should));
    }
    return {};
}

} // namespace

std::optional<PartingStep> partingStepOf(const Scene &right, const Scene &defective)
{
    const auto rightRun = traceScene(right);
    const auto defectiveRun = traceScene(defective);
    if (!rightRun || !defectiveRun || rightRun->method != defectiveRun->method)
        return std::nullopt;
    const ScanTrace &expected = *rightRun->trace;
    const ScanTrace &found = *defectiveRun->trace;
    const std::size_t common = std::min(expected.stepCount(), found.stepCount());
    for (std::size_t index = 0; index < common; ++index) {
        const TraceStep step = found.stepAt(index);
        const QString heading = explainStep(*defectiveRun, index).heading;
        if (expected.stepAt(index) != step)
            return PartingStep{index, heading,
                               QStringLiteral("the right run is at “%1” here")
                                   .arg(explainStep(*rightRun, index).heading)};
        const QString text = partingText(numbersOf(expected, step), numbersOf(found, step));
        if (!text.isEmpty())
            return PartingStep{index, heading, text};
    }
    if (expected.stepCount() == found.stepCount())
        return std::nullopt;
    const bool endsEarly = found.stepCount() < expected.stepCount();
    const TracedScene &longer = endsEarly ? *rightRun : *defectiveRun;
    return PartingStep{common, explainStep(longer, common).heading,
                       endsEarly ? QStringLiteral("this is not drawn any more")
                                 : QStringLiteral("this is drawn beyond the right run")};
}

} // namespace pixelplumb
