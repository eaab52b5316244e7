// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/scantrace.h"

namespace pixelplumb {

namespace {

/// Passes each sample of a span that is walked again to a function.
class SampleVisitor final : public Listener {
public:
    explicit SampleVisitor(const std::function<void(const SampleVisit &)> &visit)
        : m_visit(&visit)
    {
    }

    void primitiveBegun(const void *) override { }
    void primitiveRejected(const Rejection &) override { }
    void spanEntered(const void *) override { }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb, const void *sample) override
    {
        (*m_visit)({x, y, SampleFate::Refused, sample});
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const void *sample) override
    {
        (*m_visit)({x, y, SampleFate::Written, sample});
    }

private:
    const std::function<void(const SampleVisit &)> *m_visit;
};

/// False for primitives that were begun with nothing computed.
bool wasComputed(const std::optional<Rejection> &rejection)
{
    return !(rejection == PrimitiveRejection::NotOfThisMethod
             || rejection == PrimitiveRejection::NotRepresentable
             || rejection == PrimitiveRejection::OutlineTooLarge);
}

} // namespace

StatePlace ScanTrace::stateOfSpan(std::size_t span) const
{
    const std::size_t primitive = primitiveOf(span);
    return {m_settings, primitive, span, firstSpanOf(primitive)};
}

void ScanTrace::visitSamples(std::size_t span, const Visit &visit) const
{
    if (m_states->bytesOfSample() == 0) {
        SampleVisitor visitor(visit);
        m_states->walkAgain(stateOfSpan(span), visitor);
        return;
    }
    for (std::size_t sample = firstSampleOf(span); sample < endSampleOf(span); ++sample) {
        const PixelChange &change = m_samples[sample];
        visit({change.x, change.y, change.isWritten() ? SampleFate::Written : SampleFate::Refused,
               m_states->keptSample(sample)});
    }
}

SetUpRecord ScanTrace::setUp(std::size_t primitive) const
{
    SetUpRecord record;
    record.primitive = primitive;
    record.rejection = m_primitives[primitive].rejection;
    m_states->read(stateOfSetUp(primitive), record);
    if (wasComputed(record.rejection))
        record.cells = m_states->cells(stateOfSetUp(primitive));
    else
        record.cells.resize(m_numbers.setUp.size());
    return record;
}

SpanRecord ScanTrace::span(std::size_t span) const
{
    SpanRecord record;
    record.primitive = primitiveOf(span);
    record.place = placeOf(span);
    const StatePlace place = stateOfSpan(span);
    m_states->read(place, record);
    record.cells = m_states->cells(place);
    return record;
}

std::vector<SampleRecord> ScanTrace::samplesWith(std::size_t span, SampleCells cells) const
{
    const StatePlace place = stateOfSpan(span);
    std::vector<SampleRecord> records;
    visitSamples(span, [&](const SampleVisit &visit) {
        SampleRecord &record = records.emplace_back();
        record.x = visit.x;
        record.y = visit.y;
        record.fate = visit.fate;
        m_states->read(place.at(visit), record);
        if (cells == SampleCells::Filled)
            record.cells = m_states->cells(place.at(visit));
    });
    return records;
}

StepWords ScanTrace::setUpWords(std::size_t primitive) const
{
    return m_states->words(stateOfSetUp(primitive));
}

StepWords ScanTrace::spanWords(std::size_t span) const
{
    return m_states->words(stateOfSpan(span));
}

StepWords ScanTrace::sampleWords(std::size_t span, std::size_t place) const
{
    StepWords words;
    std::size_t visited = 0;
    visitSamples(span, [&](const SampleVisit &visit) {
        if (visited++ == place)
            words = m_states->words(stateOfSpan(span).at(visit));
    });
    return words;
}

std::vector<std::vector<NumberDescription>> ScanTrace::sampleNumbers(std::size_t span) const
{
    std::vector<std::vector<NumberDescription>> numbers;
    visitSamples(span, [&](const SampleVisit &visit) {
        numbers.push_back(m_states->descriptions(stateOfSpan(span).at(visit)));
    });
    return numbers;
}

} // namespace pixelplumb
