// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/kernelstates.h"
#include "core/trace/pixelchanges.h"

#include <functional>

namespace pixelplumb {

/// What a step of a trace did.
enum class StepKind {
    SetUp, ///< a primitive was begun (or rejected)
    Span, ///< a span was entered: its numbers are known, but none of its samples is decided
    Sample, ///< a sample was written or refused
};

/// A step's place in the trace. Indices count through all primitives.
struct TraceStep {
    StepKind kind = StepKind::SetUp;
    std::size_t primitive = 0;
    std::size_t span = 0; ///< meaningful for Span and Sample
    std::size_t sample = 0; ///< meaningful for Sample

    friend bool operator==(const TraceStep &, const TraceStep &) = default;
};

/// The record of a whole run: what the kernel announced, in the numbers that it used. A position p
/// in 0 … stepCount() means that the first p steps are done; step p − 1 is the current one.
class ScanTrace final {
public:
    ScanTrace(const ScanSettings &settings, std::unique_ptr<KernelStates> states);

    const ScanSettings &settings() const { return m_settings; }
    const TraceNumbers &numbers() const { return m_numbers; }
    /// True when the recorder's limit ended the recording early.
    bool isCut() const { return m_cut; }

    std::size_t primitiveCount() const { return m_primitives.size(); }
    std::size_t spanCount() const { return m_spans.size(); }
    /// Number of samples that the kernel visited, written or refused.
    std::size_t sampleCount() const { return m_samples.size(); }
    std::size_t writtenCount() const { return sampleCount() - m_refusals; }
    std::size_t stepCount() const { return primitiveCount() + spanCount() + sampleCount(); }

    /// The step at an index in 0 … stepCount() − 1.
    TraceStep stepAt(std::size_t index) const;
    std::size_t indexOfSetUp(std::size_t primitive) const { return m_primitives[primitive].step; }
    std::size_t indexOfSpan(std::size_t span) const { return m_spans[span].step; }
    std::size_t indexOfSample(std::size_t sample) const;

    /// How many samples are decided at a position.
    std::size_t samplesDoneAt(std::size_t position) const;

    const PixelChanges &changes() const { return m_samples; }
    /// The samples whose levels left 0 … 255, ascending.
    const std::vector<std::size_t> &clampedSamples() const { return m_clampedSamples; }
    /// The primitives that draw nothing, ascending; setUp() says why.
    const std::vector<std::size_t> &rejectedPrimitives() const { return m_rejected; }
    std::size_t firstSpanOf(std::size_t primitive) const
    {
        return m_primitives[primitive].firstSpan;
    }
    std::size_t endSpanOf(std::size_t primitive) const;
    std::size_t firstSampleOf(std::size_t span) const { return m_spans[span].firstSample; }
    std::size_t endSampleOf(std::size_t span) const;
    std::size_t primitiveOf(std::size_t span) const { return m_spans[span].primitive; }
    const SpanPlace &placeOf(std::size_t span) const { return m_spans[span].place; }
    /// Whether a span begins a part of its primitive: formulas start afresh there.
    bool beginsPart(std::size_t span) const;
    /// The span to which a sample belongs.
    std::size_t spanOf(std::size_t sample) const;
    /// The first span of a primitive on a column or row; none where it has no such span.
    std::optional<std::size_t> spanOn(std::size_t primitive, SpanAxis axis,
                                      std::int64_t coordinate) const;
    /// The primitive's span on the pixel's column, else on its row, that is nearest to the pixel:
    /// by its bounds, or by its samples where it has none. The first of equally near spans; none
    /// where there is no such span.
    std::optional<std::size_t> spanNear(std::size_t primitive, std::int64_t x,
                                        std::int64_t y) const;
    /// The primitive's last visit that wrote the pixel, else the last that refused it.
    std::optional<std::size_t> visitOf(std::size_t primitive, std::int64_t x, std::int64_t y) const;

    SetUpRecord setUp(std::size_t primitive) const;
    SpanRecord span(std::size_t span) const;
    /// The span's samples in order: the kernel's own loop run again from the span's recorded
    /// state.
    std::vector<SampleRecord> samples(std::size_t span) const
    {
        return samplesWith(span, SampleCells::Filled);
    }
    /// samples() with empty cells, in a tenth of the time.
    std::vector<SampleRecord> samplesWithoutCells(std::size_t span) const
    {
        return samplesWith(span, SampleCells::Empty);
    }

    /// How the numbers of these records are named at the step, and what is said about it.
    StepWords setUpWords(std::size_t primitive) const;
    StepWords spanWords(std::size_t span) const;
    /// The words of the sample at this place in the span, from 0.
    StepWords sampleWords(std::size_t span, std::size_t place) const;
    /// How the numbers of each sample of the span are named, in order, as in sampleWords().
    std::vector<std::vector<NumberDescription>> sampleNumbers(std::size_t span) const;

private:
    friend class TraceRecorder;

    struct PrimitiveEntry {
        std::size_t step = 0;
        std::size_t firstSpan = 0;
        std::optional<Rejection> rejection;
    };
    struct SpanEntry {
        std::size_t step = 0;
        std::size_t firstSample = 0;
        std::size_t primitive = 0;
        SpanPlace place;
    };
    enum class SampleCells { Filled, Empty };
    using Visit = std::function<void(const SampleVisit &)>;

    StatePlace stateOfSetUp(std::size_t primitive) const { return {m_settings, primitive}; }
    StatePlace stateOfSpan(std::size_t span) const;
    void visitSamples(std::size_t span, const Visit &visit) const;
    std::vector<SampleRecord> samplesWith(std::size_t span, SampleCells cells) const;

    ScanSettings m_settings;
    std::unique_ptr<KernelStates> m_states;
    TraceNumbers m_numbers;
    bool m_cut = false;
    std::vector<PrimitiveEntry> m_primitives;
    std::vector<SpanEntry> m_spans;
    PixelChanges m_samples;
    std::size_t m_refusals = 0;
    std::vector<std::size_t> m_clampedSamples;
    std::vector<std::size_t> m_rejected;
};

} // namespace pixelplumb
