// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/scantrace.h"

#include <algorithm>

namespace pixelplumb {

ScanTrace::ScanTrace(const ScanSettings &settings, std::unique_ptr<KernelStates> states)
    : m_settings(settings)
    , m_states(std::move(states))
    , m_numbers(m_states->numbers())
{
}

TraceStep ScanTrace::stepAt(std::size_t index) const
{
    Q_ASSERT(index < stepCount());
    TraceStep step;
    const auto primitive
        = std::ranges::upper_bound(m_primitives, index, {}, &PrimitiveEntry::step) - 1;
    step.primitive = std::size_t(primitive - m_primitives.begin());
    if (primitive->step == index)
        return step;
    const auto span = std::ranges::upper_bound(m_spans, index, {}, &SpanEntry::step) - 1;
    step.span = std::size_t(span - m_spans.begin());
    step.kind = span->step == index ? StepKind::Span : StepKind::Sample;
    if (step.kind == StepKind::Sample)
        step.sample = span->firstSample + (index - span->step - 1);
    return step;
}

std::size_t ScanTrace::indexOfSample(std::size_t sample) const
{
    const SpanEntry &span = m_spans[spanOf(sample)];
    return span.step + 1 + (sample - span.firstSample);
}

std::size_t ScanTrace::samplesDoneAt(std::size_t position) const
{
    const auto next = std::ranges::lower_bound(m_spans, position, {}, &SpanEntry::step);
    if (next == m_spans.begin())
        return 0;
    const auto span = next - 1;
    const std::size_t samplesOfSpan
        = endSampleOf(std::size_t(span - m_spans.begin())) - span->firstSample;
    return span->firstSample + std::min(samplesOfSpan, position - span->step - 1);
}

std::size_t ScanTrace::endSpanOf(std::size_t primitive) const
{
    return primitive + 1 < m_primitives.size() ? m_primitives[primitive + 1].firstSpan
                                               : m_spans.size();
}

std::size_t ScanTrace::endSampleOf(std::size_t span) const
{
    return span + 1 < m_spans.size() ? m_spans[span + 1].firstSample : m_samples.size();
}

bool ScanTrace::beginsPart(std::size_t span) const
{
    return span == firstSpanOf(primitiveOf(span)) || placeOf(span - 1).part != placeOf(span).part;
}

std::size_t ScanTrace::spanOf(std::size_t sample) const
{
    // The last span that starts at or before the sample: empty spans share their successor's start.
    const auto next = std::ranges::upper_bound(m_spans, sample, {}, &SpanEntry::firstSample);
    return std::size_t(next - m_spans.begin()) - 1;
}

std::optional<std::size_t> ScanTrace::spanOn(std::size_t primitive, SpanAxis axis,
                                             std::int64_t coordinate) const
{
    const std::size_t first = firstSpanOf(primitive);
    const std::size_t end = endSpanOf(primitive);
    if (first == end)
        return std::nullopt;
    // Most methods walk neighbouring columns or rows in order: look there first.
    const SpanPlace &start = m_spans[first].place;
    const std::int64_t distance = coordinate - start.coordinate;
    if (start.axis == axis && distance >= 0 && distance < std::int64_t(end - first)
        && m_spans[first + std::size_t(distance)].place.coordinate == coordinate
        && m_spans[first + std::size_t(distance)].place.axis == axis)
        return first + std::size_t(distance);
    for (std::size_t span = first; span < end; ++span) {
        const SpanPlace &place = m_spans[span].place;
        if (place.axis == axis && place.coordinate == coordinate)
            return span;
    }
    return std::nullopt;
}

std::optional<std::size_t> ScanTrace::spanNear(std::size_t primitive, std::int64_t x,
                                               std::int64_t y) const
{
    std::optional<std::size_t> nearest = spanOn(primitive, SpanAxis::Column, x);
    if (!nearest)
        nearest = spanOn(primitive, SpanAxis::Row, y);
    if (!nearest)
        return std::nullopt;
    const SpanPlace place = m_spans[*nearest].place;
    const auto sample = double(place.axis == SpanAxis::Column ? y : x);
    const auto distanceOf = [&](std::size_t index) {
        const SpanRecord record = span(index);
        const bool isBounded = !record.lower.isNone() && !record.upper.isNone();
        const double first = isBounded ? record.lower.toDouble() : double(record.firstSample);
        const double last = isBounded ? record.upper.toDouble() : double(record.endSample - 1);
        return std::max({0.0, first - sample, sample - last});
    };
    double least = distanceOf(*nearest);
    for (std::size_t other = *nearest + 1; least > 0 && other < endSpanOf(primitive); ++other) {
        if (m_spans[other].place.axis != place.axis
            || m_spans[other].place.coordinate != place.coordinate)
            continue;
        if (const double distance = distanceOf(other); distance < least) {
            least = distance;
            nearest = other;
        }
    }
    return nearest;
}

std::optional<std::size_t> ScanTrace::visitOf(std::size_t primitive, std::int64_t x,
                                              std::int64_t y) const
{
    std::optional<std::size_t> found;
    const auto look = [&](std::size_t sample) {
        const PixelChange &change = m_samples[sample];
        if (change.x == x && change.y == y
            && (change.isWritten() || !found || !m_samples[*found].isWritten()))
            found = sample;
    };
    const std::size_t end = endSpanOf(primitive);
    for (std::size_t span = firstSpanOf(primitive); span < end; ++span) {
        const SpanPlace &place = m_spans[span].place;
        if ((place.axis == SpanAxis::Column && place.coordinate != x)
            || (place.axis == SpanAxis::Row && place.coordinate != y))
            continue;
        const std::size_t first = firstSampleOf(span);
        const std::size_t last = endSampleOf(span);
        if (first == last)
            continue;
        // The samples of a column or row are adjacent and in order.
        const PixelChange &start = m_samples[first];
        const std::int64_t distance = place.axis == SpanAxis::Column ? y - start.y : x - start.x;
        if (place.axis != SpanAxis::Free && distance >= 0 && distance < std::int64_t(last - first)
            && m_samples[first + std::size_t(distance)].x == x
            && m_samples[first + std::size_t(distance)].y == y) {
            look(first + std::size_t(distance));
            continue;
        }
        for (std::size_t sample = first; sample < last; ++sample)
            look(sample);
    }
    return found;
}

} // namespace pixelplumb
