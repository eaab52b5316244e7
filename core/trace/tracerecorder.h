// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/scantrace.h"

#include <functional>

namespace pixelplumb {

/// Whether a recording keeps every sample or the numbers of the spans alone.
enum class TraceDetail { Samples, Spans };

/// Limits and company of a recording.
struct TraceOptions {
    /// Recording ends, and the trace says so, when this many samples are recorded (16 bytes each).
    std::size_t sampleLimit = std::size_t(1) << 24;
    /// The same for spans (about 400 bytes each).
    std::size_t spanLimit = std::size_t(1) << 18;
    /// Called at every span with the spans entered so far; returning false cancels the recording.
    std::function<bool(std::size_t spansEntered)> progress;
    TraceDetail detail = TraceDetail::Samples;
};

/// Thrown out of a kernel by the recorder when the recording is cancelled or its limit is reached;
/// the tracing function that started the kernel catches it. Kernels hold nothing that needs
/// undoing.
struct RecordingEnded {
    enum class Why { Cancelled, LimitReached } why;
};

/// How a kernel's numbers become records. A recording names
///   SetUp, Span, Sample    the kernel's numbers, as its observers hear them;
///   placeOf(span)          where the span lies;
///   record(…)              fills a SetUpRecord, SpanRecord or SampleRecord with them;
///   isClamped(sample)      whether a level left 0 … 255;
/// and, where the samples of a span can be walked again from its state,
///   walk(setUp, span, settings, observer)
/// which calls the kernel's own loop with the observer. Where there is no such function the
/// samples themselves are kept.
template <class R>
concept Recording = requires(const typename R::SetUp &setUp, const typename R::Span &span,
                             const typename R::Sample &sample, SetUpRecord &setUpRecord,
                             SpanRecord &spanRecord, SampleRecord &sampleRecord)
{
    R::record(setUp, setUpRecord);
    R::record(span, spanRecord);
    R::record(sample, sampleRecord);
    {
        R::placeOf(span)
        } -> std::same_as<SpanPlace>;
    {
        R::isClamped(sample)
        } -> std::same_as<bool>;
};

/// Hears one span being walked and keeps its samples.
template <Recording R>
struct SampleCollector {
    std::vector<SampleRecord> *samples;

    void primitiveBegun(const typename R::SetUp &) { }
    void primitiveRejected(PrimitiveRejection) { }
    void spanEntered(const typename R::Span &) { }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb, const typename R::Sample &sample)
    {
        collect(x, y, SampleFate::Refused, sample);
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const typename R::Sample &sample)
    {
        collect(x, y, SampleFate::Written, sample);
    }

private:
    void collect(std::int64_t x, std::int64_t y, SampleFate fate, const typename R::Sample &sample)
    {
        SampleRecord &record = samples->emplace_back();
        record.x = x;
        record.y = y;
        record.fate = fate;
        record.clamped = fate == SampleFate::Written && R::isClamped(sample);
        R::record(sample, record);
    }
};

/// True where the samples of a span can be walked again.
template <class R>
concept Rewalkable = requires(const typename R::SetUp &setUp, const typename R::Span &span,
                              const ScanSettings &settings, SampleCollector<R> observer)
{
    R::walk(setUp, span, settings, observer);
};

template <Recording R>
class TraceRecorder;

/// A trace in the very numbers of one kernel.
template <Recording R>
class TypedTrace final : public ScanTrace {
public:
    explicit TypedTrace(const ScanSettings &settings)
        : ScanTrace(settings)
    {
    }

    SetUpRecord setUp(std::size_t primitive) const override
    {
        SetUpRecord record;
        record.primitive = primitive;
        record.rejection = m_setUps[primitive].rejection;
        R::record(m_setUps[primitive].setUp, record);
        return record;
    }
    SpanRecord span(std::size_t span) const override
    {
        SpanRecord record;
        record.primitive = primitiveOf(span);
        record.place = placeOf(span);
        R::record(m_states[span], record);
        return record;
    }
    std::vector<SampleRecord> samples(std::size_t span) const override
    {
        std::vector<SampleRecord> records;
        SampleCollector<R> collector{&records};
        if constexpr (Rewalkable<R>) {
            R::walk(m_setUps[primitiveOf(span)].setUp, m_states[span], m_settings, collector);
        } else {
            for (std::size_t sample = firstSampleOf(span); sample < endSampleOf(span); ++sample) {
                const PixelChange &change = changes()[sample];
                if (change.isWritten())
                    collector.pixelWritten(change.x, change.y, change.before, change.after,
                                           m_kept[sample]);
                else
                    collector.sampleRejected(change.x, change.y, change.before, m_kept[sample]);
            }
        }
        return records;
    }

private:
    friend class TraceRecorder<R>;

    struct TypedSetUp {
        typename R::SetUp setUp;
        std::optional<PrimitiveRejection> rejection;
    };
    std::vector<TypedSetUp> m_setUps;
    std::vector<typename R::Span> m_states;
    std::vector<typename R::Sample> m_kept; ///< by sample, where spans cannot be walked again
};

/// The observer that writes a trace.
template <Recording R>
class TraceRecorder {
public:
    TraceRecorder(TypedTrace<R> &trace, const TraceOptions &options)
        : m_trace(&trace)
        , m_options(&options)
    {
    }

    void primitiveBegun(const typename R::SetUp &setUp)
    {
        m_trace->m_primitives.push_back({m_trace->stepCount(), m_trace->spanCount()});
        m_trace->m_setUps.push_back({setUp, std::nullopt});
    }
    void primitiveRejected(PrimitiveRejection reason)
    {
        m_trace->m_setUps.back().rejection = reason;
    }
    void spanEntered(const typename R::Span &span)
    {
        if (m_options->progress && !m_options->progress(m_trace->spanCount()))
            throw RecordingEnded{RecordingEnded::Why::Cancelled};
        if (m_trace->spanCount() >= m_options->spanLimit)
            endAtLimit();
        m_trace->m_spans.push_back({m_trace->stepCount(), m_trace->sampleCount(),
                                    m_trace->primitiveCount() - 1, R::placeOf(span)});
        m_trace->m_states.push_back(span);
    }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel,
                        const typename R::Sample &sample)
    {
        if (m_options->detail == TraceDetail::Spans)
            return;
        append(PixelChange::refused(std::int32_t(x), std::int32_t(y), pixel), sample);
        ++m_trace->m_refusals;
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                      const typename R::Sample &sample)
    {
        if (m_options->detail == TraceDetail::Spans)
            return;
        if (R::isClamped(sample))
            m_trace->m_clampedSamples.push_back(m_trace->sampleCount());
        append({std::int32_t(x), std::int32_t(y), before, after}, sample);
    }

private:
    void append(const PixelChange &change, const typename R::Sample &sample)
    {
        if (m_trace->sampleCount() >= m_options->sampleLimit)
            endAtLimit();
        if constexpr (!Rewalkable<R>)
            m_trace->m_kept.push_back(sample);
        m_trace->m_samples.append(change);
    }
    [[noreturn]] void endAtLimit()
    {
        m_trace->m_cut = true;
        throw RecordingEnded{RecordingEnded::Why::LimitReached};
    }

    TypedTrace<R> *m_trace;
    const TraceOptions *m_options;
};

/// Records what `scan(primitive, recorder)` announces for each primitive of the method's kinds;
/// the others are noted as rejected. Null when options.progress cancelled it.
template <Recording R, class Draws, class Scan>
std::unique_ptr<ScanTrace> recordTrace(std::size_t primitiveCount, const ScanSettings &settings,
                                       const TraceOptions &options, const Draws &draws,
                                       const Scan &scan)
{
    auto trace = std::make_unique<TypedTrace<R>>(settings);
    TraceRecorder<R> recorder(*trace, options);
    try {
        for (std::size_t primitive = 0; primitive < primitiveCount; ++primitive) {
            if (draws(primitive)) {
                scan(primitive, recorder);
                continue;
            }
            recorder.primitiveBegun({});
            recorder.primitiveRejected(PrimitiveRejection::NotOfThisMethod);
        }
    } catch (const RecordingEnded &ended) {
        if (ended.why == RecordingEnded::Why::Cancelled)
            return nullptr;
    }
    return trace;
}

} // namespace pixelplumb
