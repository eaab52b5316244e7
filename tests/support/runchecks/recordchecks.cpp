// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/runcheck.h"
#include "tests/support/spread.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

/// How many spans of a run have their words checked.
constexpr std::size_t mostSpans = 12;

/// Whether the words describe these numbers, each in its position.
bool describe(const StepWords &words, const std::vector<NumberDescription> &numbers)
{
    return std::ranges::equal(words.numbers, numbers, {}, &NumberDescription::id,
                              &NumberDescription::id);
}

QString cellFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    const TraceNumbers &numbers = trace.numbers();
    for (std::size_t i = 0; i < trace.primitiveCount(); ++i) {
        if (trace.setUp(i).cells.size() != numbers.setUp.size()
            || !describe(trace.setUpWords(i), numbers.setUp))
            return u"set-up %1"_s.arg(i);
    }
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        if (trace.span(span).cells.size() != numbers.span.size())
            return u"span %1"_s.arg(span);
        for (const SampleRecord &sample : trace.samples(span)) {
            if (sample.cells.size() != numbers.sample.size())
                return u"sample (%1, %2)"_s.arg(sample.x).arg(sample.y);
        }
    }
    for (const std::size_t span : spreadOver(trace.spanCount(), mostSpans)) {
        if (!describe(trace.spanWords(span), numbers.span))
            return u"words of span %1"_s.arg(span);
        if (trace.firstSampleOf(span) < trace.endSampleOf(span)
            && !describe(trace.sampleWords(span, 0), numbers.sample))
            return u"words of a sample of span %1"_s.arg(span);
    }
    return {};
}

/// Whether a sample lies at the position in its column or row that its order implies.
bool isInOrder(const SampleRecord &sample, const SpanRecord &span, std::size_t place)
{
    const bool isRow = span.place.axis == SpanAxis::Row;
    return (isRow ? sample.x : sample.y) == span.firstDrawn + std::int64_t(place)
        && (isRow ? sample.y : sample.x) == span.place.coordinate;
}

QString sampleFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    // With effects, a pixel may be visited for several samples.
    if (run.traced->shading())
        return {};
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const SpanRecord record = trace.span(span);
        const std::vector<SampleRecord> samples = trace.samples(span);
        const bool isOrdered = record.place.axis != SpanAxis::Free
            && run.traced->primitives.isTriangle(record.primitive);
        if (samples.size() != trace.endSampleOf(span) - trace.firstSampleOf(span)
            || (isOrdered && std::int64_t(samples.size()) != record.drawnSamples()))
            return u"span %1 has %2 samples"_s.arg(span).arg(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const PixelChange &change = trace.changes()[trace.firstSampleOf(span) + i];
            if (samples[i].x != change.x || samples[i].y != change.y
                || (samples[i].fate == SampleFate::Written) != change.isWritten()
                || (isOrdered && !isInOrder(samples[i], record, i)))
                return u"sample %1 of span %2"_s.arg(i).arg(span);
        }
    }
    return {};
}

QString indexFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    std::size_t samples = 0;
    for (std::size_t index = 0; index < trace.stepCount(); ++index) {
        const TraceStep step = trace.stepAt(index);
        bool isRight = trace.samplesDoneAt(index) == samples;
        switch (step.kind) {
        case StepKind::SetUp:
            isRight = isRight && trace.indexOfSetUp(step.primitive) == index;
            break;
        case StepKind::Span:
            isRight = isRight && trace.indexOfSpan(step.span) == index
                && trace.primitiveOf(step.span) == step.primitive;
            break;
        case StepKind::Sample:
            isRight = isRight && trace.indexOfSample(step.sample) == index
                && trace.spanOf(step.sample) == step.span && step.sample == samples;
            ++samples;
            break;
        }
        if (!isRight)
            return u"step %1"_s.arg(index);
    }
    return samples == trace.sampleCount() ? QString() : u"%1 samples"_s.arg(samples);
}

/// The numbers without an exact counterpart in files that a double cannot hold.
QStringList lossyNumbers(const std::vector<NumberDescription> &numbers,
                         const std::vector<Quantity> &cells)
{
    QStringList lossy;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool isAlone = numbers[i].comparison == Comparison::None && cells[i].isRational();
        if (isAlone && errorOf(Quantity::of(cells[i].toDouble()), cells[i]) != 0)
            lossy.append(numbers[i].id);
    }
    return lossy;
}

/// Fixed point has its own fractions, which end in a file's decimals.
QString lossFault(const CheckedRun &run)
{
    const ScanTrace &trace = *run.traced->trace;
    if (trace.settings().arithmetic != Arithmetic::Exact)
        return {};
    QStringList lossy;
    for (std::size_t i = 0; i < trace.primitiveCount(); ++i)
        lossy += lossyNumbers(trace.numbers().setUp, trace.setUp(i).cells);
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        lossy += lossyNumbers(trace.numbers().span, trace.span(span).cells);
        for (const SampleRecord &sample : trace.samples(span))
            lossy += lossyNumbers(trace.numbers().sample, sample.cells);
    }
    lossy.removeDuplicates();
    return lossy.join(u", "_s);
}

} // namespace

std::vector<RunCheck> recordChecks()
{
    return {{u"every record has a cell and words for each number"_s, cellFault},
            {u"the samples of a span are its changes, in their order"_s, sampleFault},
            {u"the index of a step leads back to the step"_s, indexFault},
            {u"what a double cannot hold has its exact number"_s, lossFault}};
}

} // namespace pixelplumb
