// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/recording.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

/// The states of a run in the numbers of a recording.
template <Recording R>
class StatesOf final : public KernelStates {
public:
    using Tables = std::shared_ptr<const TablesOf<R>>;

    explicit StatesOf(const Tables &tables)
        : m_tables(tables)
    {
    }

    TraceNumbers numbers() const override
    {
        return {descriptionsOf(m_tables->setUp), descriptionsOf(m_tables->span),
                descriptionsOf(m_tables->sample)};
    }

    void keepSetUp(const void *setUp) override
    {
        m_setUps.push_back(setUp ? *static_cast<const SetUp *>(setUp) : SetUp{});
    }
    SpanPlace keepSpan(const void *span) override
    {
        m_spans.push_back(*static_cast<const Span *>(span));
        return R::placeOf(m_spans.back());
    }
    std::size_t crossingsIn([[maybe_unused]] const void *span) const override
    {
        if constexpr (requires(const Span &row) { row.crossings.size(); })
            return static_cast<const Span *>(span)->crossings.size();
        else
            return 0;
    }
    bool isClamped(const void *sample) const override { return R::isClamped(sampleAt(sample)); }

    std::size_t bytesOfSample() const override { return canWalkAgain<R> ? 0 : sizeof(Sample); }
    void keepSample([[maybe_unused]] const void *sample) override
    {
        if constexpr (!canWalkAgain<R>)
            m_samples.push_back(sampleAt(sample));
    }
    const void *keptSample(std::size_t sample) const override { return &m_samples[sample]; }
    void walkAgain([[maybe_unused]] const StatePlace &place,
                   [[maybe_unused]] Listener &listener) const override
    {
        if constexpr (canWalkAgain<R>)
            R::walk(m_setUps[place.primitive], m_spans[*place.span], place.settings,
                    ObserverOf<R>(listener));
    }

    void read(const StatePlace &place, SetUpRecord &record) const override
    {
        R::record(m_setUps[place.primitive], record);
    }
    void read(const StatePlace &place, SpanRecord &record) const override
    {
        R::record(m_spans[*place.span], record);
        if constexpr (requires(const CurrentSpanOf<R> &step) { R::record(step, record); })
            R::record(currentSpan(place), record);
    }
    void read(const StatePlace &place, SampleRecord &record) const override
    {
        const Sample &sample = sampleAt(place.visit->state);
        record.clamped = place.visit->fate == SampleFate::Written && R::isClamped(sample);
        R::record(sample, record);
        if constexpr (requires(const CurrentSampleOf<R> &step) { R::record(step, record); })
            R::record(currentSample(place), record);
    }

    std::vector<Quantity> cells(const StatePlace &place) const override
    {
        return atStep(place,
                      [](const auto &table, const auto &state) { return cellsOf(table, state); });
    }
    StepWords words(const StatePlace &place) const override
    {
        return atStep(
            place, [](const auto &table, const auto &state) { return wordsOf<R>(table, state); });
    }
    std::vector<NumberDescription> descriptions(const StatePlace &place) const override
    {
        return atStep(place, [](const auto &table, const auto &state) {
            return descriptionsIn(table, state);
        });
    }

private:
    using SetUp = typename R::SetUp;
    using Span = typename R::Span;
    using Sample = typename R::Sample;

    static const Sample &sampleAt(const void *sample)
    {
        return *static_cast<const Sample *>(sample);
    }

    CurrentSetUpOf<R> currentSetUp(const StatePlace &place) const
    {
        return {place.primitive, place.settings, m_setUps[place.primitive]};
    }
    CurrentSpanOf<R> currentSpan(const StatePlace &place) const
    {
        const std::size_t span = *place.span;
        return {currentSetUp(place), m_spans[span],
                span == place.firstSpan ? nullptr : &m_spans[span - 1]};
    }
    CurrentSampleOf<R> currentSample(const StatePlace &place) const
    {
        const SampleVisit &visit = *place.visit;
        return {currentSpan(place), sampleAt(visit.state), visit.x, visit.y, visit.fate};
    }
    /// Calls function(table, state) for the level of the step.
    template <class Function>
    auto atStep(const StatePlace &place, const Function &function) const
    {
        if (place.visit)
            return function(m_tables->sample, stateOf<R>(currentSample(place)));
        if (place.span)
            return function(m_tables->span, stateOf<R>(currentSpan(place)));
        return function(m_tables->setUp, stateOf<R>(currentSetUp(place)));
    }

    Tables m_tables;
    std::vector<SetUp> m_setUps;
    std::vector<Span> m_spans;
    std::vector<Sample> m_samples; ///< where spans cannot be walked again
};

/// Records a scan in the numbers of a recording: `scan(primitive, observer)` takes an
/// ObserverOf<R>.
template <Recording R, class Draws, class Scan>
std::unique_ptr<ScanTrace> recordTrace(std::size_t primitiveCount, const ScanSettings &settings,
                                       const TraceOptions &options, const Draws &draws,
                                       const Scan &scan,
                                       const typename StatesOf<R>::Tables &tables
                                       = TablesOf<R>::common())
{
    return recordTrace(primitiveCount, settings, options,
                       {draws,
                        [&scan](std::size_t primitive, Listener &listener) {
                            scan(primitive, ObserverOf<R>(listener));
                        }},
                       std::make_unique<StatesOf<R>>(tables));
}

} // namespace pixelplumb
