// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/recording.h"
#include "core/trace/scantrace.h"

#include <functional>

namespace pixelplumb {

/// An observer of one span's walk that passes each sample to a function.
template <Recording R>
struct SampleVisitor {
    using Visit = std::function<void(std::int64_t x, std::int64_t y, SampleFate fate,
                                     const typename R::Sample &sample)>;
    const Visit *visit;

    void primitiveBegun(const typename R::SetUp &) { }
    void primitiveRejected(const Rejection &) { }
    void spanEntered(const typename R::Span &) { }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb, const typename R::Sample &sample)
    {
        (*visit)(x, y, SampleFate::Refused, sample);
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const typename R::Sample &sample)
    {
        (*visit)(x, y, SampleFate::Written, sample);
    }
};

template <class R>
inline constexpr bool canWalkAgain = Rewalkable<R, SampleVisitor<R>>;

template <Recording R>
class TraceRecorder;

/// A trace in one kernel's own numbers.
template <Recording R>
class TypedTrace final : public ScanTrace {
public:
    using Tables = std::shared_ptr<const TablesOf<R>>;

    TypedTrace(const ScanSettings &settings, const Tables &tables)
        : ScanTrace(settings,
                    {descriptionsOf(tables->setUp), descriptionsOf(tables->span),
                     descriptionsOf(tables->sample)})
        , m_tables(tables)
    {
    }

    SetUpRecord setUp(std::size_t primitive) const override
    {
        SetUpRecord record;
        record.primitive = primitive;
        record.rejection = m_setUps[primitive].rejection;
        R::record(m_setUps[primitive].setUp, record);
        if (wasComputed(record))
            record.cells = cellsOf(m_tables->setUp, stateOf<R>(currentSetUp(primitive)));
        else
            record.cells.resize(m_tables->setUp.size());
        return record;
    }
    SpanRecord span(std::size_t span) const override
    {
        SpanRecord record;
        record.primitive = primitiveOf(span);
        record.place = placeOf(span);
        R::record(m_states[span], record);
        record.cells = cellsOf(m_tables->span, stateOf<R>(currentSpan(span)));
        return record;
    }
    std::vector<SampleRecord> samplesWith(std::size_t span, SampleCells cells) const override
    {
        std::vector<SampleRecord> records;
        visitSamples(span,
                     [&](std::int64_t x, std::int64_t y, SampleFate fate, const Sample &sample) {
                         SampleRecord &record = records.emplace_back();
                         record.x = x;
                         record.y = y;
                         record.fate = fate;
                         record.clamped = fate == SampleFate::Written && R::isClamped(sample);
                         R::record(sample, record);
                         const CurrentSampleOf<R> current = currentSample(span, x, y, fate, sample);
                         if constexpr (requires { R::record(current, record); })
                             R::record(current, record);
                         if (cells == SampleCells::Filled)
                             record.cells = cellsOf(m_tables->sample, stateOf<R>(current));
                     });
        return records;
    }

    StepWords setUpWords(std::size_t primitive) const override
    {
        return wordsOf<R>(m_tables->setUp, stateOf<R>(currentSetUp(primitive)));
    }
    StepWords spanWords(std::size_t span) const override
    {
        return wordsOf<R>(m_tables->span, stateOf<R>(currentSpan(span)));
    }
    StepWords sampleWords(std::size_t span, std::size_t place) const override
    {
        StepWords words;
        std::size_t visited = 0;
        visitSamples(
            span, [&](std::int64_t x, std::int64_t y, SampleFate fate, const Sample &sample) {
                if (visited++ == place)
                    words = wordsOf<R>(m_tables->sample,
                                       stateOf<R>(currentSample(span, x, y, fate, sample)));
            });
        return words;
    }
    std::vector<std::vector<NumberDescription>> sampleNumbers(std::size_t span) const override
    {
        std::vector<std::vector<NumberDescription>> numbers;
        visitSamples(
            span, [&](std::int64_t x, std::int64_t y, SampleFate fate, const Sample &sample) {
                numbers.push_back(descriptionsIn(
                    m_tables->sample, stateOf<R>(currentSample(span, x, y, fate, sample))));
            });
        return numbers;
    }

private:
    friend class TraceRecorder<R>;
    using Sample = typename R::Sample;

    struct TypedSetUp {
        typename R::SetUp setUp;
        std::optional<Rejection> rejection;
    };

    /// False for primitives that were begun with nothing computed.
    static bool wasComputed(const SetUpRecord &record)
    {
        return !(record.rejection == PrimitiveRejection::NotOfThisMethod
                 || record.rejection == PrimitiveRejection::NotRepresentable);
    }

    CurrentSetUpOf<R> currentSetUp(std::size_t primitive) const
    {
        return {primitive, m_settings, m_setUps[primitive].setUp};
    }
    CurrentSpanOf<R> currentSpan(std::size_t span) const
    {
        const std::size_t primitive = primitiveOf(span);
        const bool isFirst = span == firstSpanOf(primitive);
        return {currentSetUp(primitive), m_states[span], isFirst ? nullptr : &m_states[span - 1]};
    }
    CurrentSampleOf<R> currentSample(std::size_t span, std::int64_t x, std::int64_t y,
                                     SampleFate fate, const Sample &sample) const
    {
        return {currentSpan(span), sample, x, y, fate};
    }

    void visitSamples(std::size_t span, const typename SampleVisitor<R>::Visit &visit) const
    {
        if constexpr (canWalkAgain<R>) {
            R::walk(m_setUps[primitiveOf(span)].setUp, m_states[span], m_settings,
                    SampleVisitor<R>{&visit});
        } else {
            for (std::size_t sample = firstSampleOf(span); sample < endSampleOf(span); ++sample) {
                const PixelChange &change = changes()[sample];
                visit(change.x, change.y,
                      change.isWritten() ? SampleFate::Written : SampleFate::Refused,
                      m_kept[sample]);
            }
        }
    }

    Tables m_tables;
    std::vector<TypedSetUp> m_setUps;
    std::vector<typename R::Span> m_states;
    std::vector<Sample> m_kept; ///< by sample, where spans cannot be walked again
    std::size_t m_spanWeight = 0; ///< how much of TraceOptions::spanLimit is used
};

} // namespace pixelplumb
