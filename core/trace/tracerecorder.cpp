// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

namespace {

/// Thrown out of a kernel when the recording is cancelled or its limit is reached. Kernels hold
/// nothing that needs undoing.
struct RecordingEnded {
    enum class Why { Cancelled, LimitReached } why;
};

} // namespace

/// The listener that writes a trace.
class TraceRecorder final : public Listener {
public:
    TraceRecorder(ScanTrace &trace, const TraceOptions &options)
        : m_trace(&trace)
        , m_options(&options)
        , m_states(trace.m_states.get())
        , m_sampleLimit(options.sampleLimit)
    {
        // The limit is one of memory: samples of 16 bytes.
        if (const std::size_t bytes = m_states->bytesOfSample(); bytes > 0)
            m_sampleLimit = std::min(m_sampleLimit, m_sampleLimit * 64 / bytes);
    }

    void primitiveBegun(const void *setUp) override
    {
        m_trace->m_primitives.push_back({m_trace->stepCount(), m_trace->spanCount(), std::nullopt});
        m_states->keepSetUp(setUp);
    }
    void primitiveRejected(const Rejection &rejection) override
    {
        m_trace->m_primitives.back().rejection = rejection;
        m_trace->m_rejected.push_back(m_trace->primitiveCount() - 1);
    }
    void spanEntered(const void *span) override
    {
        if (m_options->detail == TraceDetail::Rejections)
            return;
        if (!goesOn(m_options->progress,
                    {JobPhase::Recording, std::int64_t(m_trace->spanCount()), 0}))
            throw RecordingEnded{RecordingEnded::Why::Cancelled};
        if (m_spanWeight >= m_options->spanLimit)
            endAtLimit();
        m_spanWeight += 1 + m_states->crossingsIn(span) / 4;
        m_trace->m_spans.push_back({m_trace->stepCount(), m_trace->sampleCount(),
                                    m_trace->primitiveCount() - 1, m_states->keepSpan(span)});
    }
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel, const void *sample) override
    {
        if (m_options->detail != TraceDetail::Samples)
            return;
        append(PixelChange::refused(std::int32_t(x), std::int32_t(y), pixel), sample);
        ++m_trace->m_refusals;
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                      const void *sample) override
    {
        if (m_options->detail == TraceDetail::Rejections)
            throw RecordingEnded{RecordingEnded::Why::Cancelled};
        if (m_options->detail == TraceDetail::Spans)
            return;
        append({std::int32_t(x), std::int32_t(y), before, after}, sample);
        if (m_states->isClamped(sample))
            m_trace->m_clampedSamples.push_back(m_trace->sampleCount() - 1);
    }

private:
    void append(const PixelChange &change, const void *sample)
    {
        if (m_trace->sampleCount() >= m_sampleLimit)
            endAtLimit();
        m_states->keepSample(sample);
        m_trace->m_samples.append(change);
    }
    [[noreturn]] void endAtLimit()
    {
        m_trace->m_cut = true;
        throw RecordingEnded{RecordingEnded::Why::LimitReached};
    }

    ScanTrace *m_trace;
    const TraceOptions *m_options;
    KernelStates *m_states;
    std::size_t m_sampleLimit;
    std::size_t m_spanWeight = 0; ///< how much of TraceOptions::spanLimit is used
};

std::unique_ptr<ScanTrace> recordTrace(std::size_t primitiveCount, const ScanSettings &settings,
                                       const TraceOptions &options, const RecordedScan &scan,
                                       std::unique_ptr<KernelStates> states)
{
    auto trace = std::make_unique<ScanTrace>(settings, std::move(states));
    TraceRecorder recorder(*trace, options);
    try {
        for (std::size_t primitive = 0; primitive < primitiveCount; ++primitive) {
            if (scan.draws(primitive)) {
                scan.scan(primitive, recorder);
                continue;
            }
            recorder.primitiveBegun(nullptr);
            recorder.primitiveRejected(PrimitiveRejection::NotOfThisMethod);
        }
    } catch (const RecordingEnded &ended) {
        if (ended.why == RecordingEnded::Why::Cancelled)
            return nullptr;
    }
    return trace;
}

} // namespace pixelplumb
