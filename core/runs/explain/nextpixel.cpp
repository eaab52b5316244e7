// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/nextpixel.h"

#include "core/methods/words/formulatext.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/refusaltext.h"
#include "core/runs/spanheadings.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

namespace {

/// The first step whose pixel the current step's numbers do not reveal: a line's step has its pixel
/// among its numbers.
std::size_t firstUntold(const ScanTrace &trace, std::size_t position)
{
    if (position == 0 || !trace.numbers().sample.empty())
        return position;
    const TraceStep step = trace.stepAt(position - 1);
    const bool isOnePixel = step.kind == StepKind::Span
        && trace.endSampleOf(step.span) - trace.firstSampleOf(step.span) == 1;
    return isOnePixel ? position + 1 : position;
}

/// The index of the step that writes next.
std::optional<std::size_t> nextWriteAfter(const ScanTrace &trace, std::size_t position)
{
    for (std::size_t index = firstUntold(trace, position); index < trace.stepCount(); ++index) {
        const TraceStep step = trace.stepAt(index);
        if (step.kind == StepKind::Sample && trace.changes()[step.sample].isWritten())
            return index;
    }
    return std::nullopt;
}

/// Why a pixel is written: what decides each sample, in a triangle its tests, in a polygon the ray;
/// else what the span does.
QString reasonFor(const TracedScene &traced, const TraceStep &step)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t place = step.sample - trace.firstSampleOf(step.span);
    const StepWords words = trace.sampleWords(step.span, place);
    const PrimitiveKind kind = traced.primitives.kindOf(step.primitive);
    if (kind == PrimitiveKind::Polygon && !words.sentence.isEmpty())
        return words.sentence;
    QStringList tests;
    bool isRounded = false; // a span decided, and the weights are no tests
    for (const SampleDecision &test : decisionsOf(words.numbers, trace.samples(step.span)[place])) {
        if (kind != PrimitiveKind::Triangle || test.value.isNone())
            continue;
        tests += u"%1 = %2"_s.arg(test.title, term(test.value));
        isRounded = isRounded || test.value.toDouble() < 0;
    }
    return tests.isEmpty() || isRounded ? explainStep(traced, trace.indexOfSpan(step.span)).sentence
                                        : tests.join(u", "_s) + u": none is negative."_s;
}

} // namespace

std::optional<NextPixel> nextPixelAfter(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    const std::optional<std::size_t> index = nextWriteAfter(trace, position);
    if (!index)
        return std::nullopt;
    const TraceStep step = trace.stepAt(*index);
    const PixelChange &change = trace.changes()[step.sample];
    return NextPixel{{change.x, change.y}, reasonFor(traced, step), *index};
}

QString wrongPixelText(const TracedScene &traced, std::size_t position, const QPoint &pixel)
{
    const ScanTrace &trace = *traced.trace;
    const std::optional<std::size_t> index = nextWriteAfter(trace, position);
    if (!index)
        return {};
    const FrameView frame = traced.truth.view();
    if (!frame.contains(pixel.x(), pixel.y()))
        return u"It lies off the frame, columns %1 to %2 and rows %3 to %4, where "
               "nothing is written."_s.arg(frame.firstColumn)
                   .arg(frame.endColumn() - 1)
                   .arg(frame.firstRow)
                   .arg(frame.endRow() - 1);
    const TraceStep next = trace.stepAt(*index);
    const auto visit = trace.visitOf(next.primitive, pixel.x(), pixel.y());
    if (!visit || !trace.changes()[*visit].isWritten())
        return pixelAttempt(traced, next.primitive, pixel.x(), pixel.y()).reason;
    if (trace.indexOfSample(*visit) < position)
        return u"It has been drawn already, in step %1."_s.arg(trace.indexOfSample(*visit) + 1);
    if (trace.indexOfSample(*visit) < *index)
        return u"It is the pixel of the current step: which one follows it?"_s;
    const std::size_t span = trace.spanOf(*visit);
    return span == next.span
        ? u"Its turn comes later in the same span: where does the method begin?"_s
        : u"Its turn comes later: %1."_s.arg(spanHeading(trace, span));
}

} // namespace pixelplumb
