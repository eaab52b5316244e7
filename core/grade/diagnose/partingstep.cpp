// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/methods/words/formulatext.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr double leastPlain = 1e-3; // smaller errors are invisible in the two numbers

struct StepNumbers {
    std::vector<NumberDescription> descriptions;
    std::vector<Quantity> cells;
};

/// Reads a trace forward; keeps the samples of a span while they are needed.
class StepReader {
public:
    explicit StepReader(const ScanTrace &trace)
        : m_trace(trace)
    {
    }

    StepNumbers numbersOf(const TraceStep &step)
    {
        if (step.kind == StepKind::SetUp)
            return {m_trace.setUpWords(step.primitive).numbers,
                    m_trace.setUp(step.primitive).cells};
        if (step.kind == StepKind::Span)
            return {m_trace.spanWords(step.span).numbers, m_trace.span(step.span).cells};
        if (m_span != step.span) {
            m_span = step.span;
            m_samples = m_trace.samples(step.span);
        }
        const std::size_t place = step.sample - m_trace.firstSampleOf(step.span);
        return {m_trace.sampleWords(step.span, place).numbers, m_samples[place].cells};
    }

private:
    const ScanTrace &m_trace;
    std::optional<std::size_t> m_span;
    std::vector<SampleRecord> m_samples;
};

QString partingText(const StepNumbers &right, const StepNumbers &defective)
{
    for (std::size_t i = 0; i < right.cells.size() && i < defective.cells.size(); ++i) {
        const Quantity &should = right.cells[i];
        const Quantity &is = defective.cells[i];
        if (is == should || right.descriptions[i].id != defective.descriptions[i].id)
            continue;
        if (!is.isNone() && !should.isNone() && errorOf(is, should) == 0)
            continue; // the same number in two arithmetics
        const auto text = [](const Quantity &quantity) {
            return quantity.isNone() ? u"not there"_s : term(quantity);
        };
        const QString parts
            = u"%1 is %2, should be %3"_s.arg(right.descriptions[i].title, text(is), text(should));
        if (is.isNone() || should.isNone() || std::abs(errorOf(is, should)) >= leastPlain)
            return parts;
        return parts + u", off by %1"_s.arg(errorOf(is, should), 0, 'g', 3);
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
    StepReader ofRight(expected);
    StepReader ofDefective(found);
    const std::size_t common = std::min(expected.stepCount(), found.stepCount());
    for (std::size_t index = 0; index < common; ++index) {
        const TraceStep step = found.stepAt(index);
        if (expected.stepAt(index) != step)
            return PartingStep{
                index, explainStep(*defectiveRun, index).heading,
                u"the right run is at “%1” here"_s.arg(explainStep(*rightRun, index).heading)};
        const QString text = partingText(ofRight.numbersOf(step), ofDefective.numbersOf(step));
        if (!text.isEmpty())
            return PartingStep{index, explainStep(*defectiveRun, index).heading, text};
    }
    if (expected.stepCount() == found.stepCount())
        return std::nullopt;
    const bool endsEarly = found.stepCount() < expected.stepCount();
    const TracedScene &longer = endsEarly ? *rightRun : *defectiveRun;
    return PartingStep{common, explainStep(longer, common).heading,
                       endsEarly ? u"this is not drawn any more"_s
                                 : u"this is drawn beyond the right run"_s};
}

} // namespace pixelplumb
