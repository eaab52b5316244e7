// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/trace/typedtrace.h"

namespace pixelplumb {

/// Whether a recording keeps every sample or only the numbers of the spans.
enum class TraceDetail { Samples, Spans };

/// Limits, listener and detail of a recording.
struct TraceOptions {
    /// Recording ends, and the trace is marked as cut, after this many samples (16 bytes each).
    std::size_t sampleLimit = std::size_t(1) << 24;
    /// The limit for spans (about 400 bytes each; four crossings of a polygon's row count as one).
    std::size_t spanLimit = std::size_t(1) << 18;
    /// Receives at every span the number entered so far; the total is unknown.
    ProgressListener progress;
    TraceDetail detail = TraceDetail::Samples;
};

/// Thrown out of a kernel by the recorder when the recording is cancelled or its limit is reached;
/// the tracing function that started the kernel catches it. Kernels hold nothing that needs
/// undoing.
struct RecordingEnded {
    enum class Why { Cancelled, LimitReached } why;
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
    void primitiveRejected(const Rejection &rejection)
    {
        m_trace->m_setUps.back().rejection = rejection;
        m_trace->m_rejected.push_back(m_trace->primitiveCount() - 1);
    }
    void spanEntered(const typename R::Span &span)
    {
        if (!goesOn(m_options->progress,
                    {JobPhase::Recording, std::int64_t(m_trace->spanCount()), 0}))
            throw RecordingEnded{RecordingEnded::Why::Cancelled};
        if (m_trace->m_spanWeight >= m_options->spanLimit)
            endAtLimit();
        ++m_trace->m_spanWeight;
        if constexpr (requires { span.crossings.size(); })
            m_trace->m_spanWeight += span.crossings.size() / 4;
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
        if constexpr (!canWalkAgain<R>) {
            // The limit is one of memory: samples of 16 bytes.
            if (m_trace->sampleCount() >= m_options->sampleLimit * 64 / sizeof(sample))
                endAtLimit();
            m_trace->m_kept.push_back(sample);
        }
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

/// Records what `scan(primitive, recorder)` announces for each primitive of the method's kinds; the
/// others are recorded as rejected. Null when options.progress cancelled it.
template <Recording R, class Draws, class Scan>
std::unique_ptr<ScanTrace> recordTrace(std::size_t primitiveCount, const ScanSettings &settings,
                                       const TraceOptions &options, const Draws &draws,
                                       const Scan &scan,
                                       const typename TypedTrace<R>::Tables &tables
                                       = TablesOf<R>::common())
{
    auto trace = std::make_unique<TypedTrace<R>>(settings, tables);
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
