// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/listener.h"
#include "core/trace/numberdescription.h"
#include "core/trace/stepwords.h"
#include "core/trace/tracerecords.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// Descriptions of the cells in a trace's records. A run has the numbers that its plan calls for.
struct TraceNumbers {
    std::vector<NumberDescription> setUp; ///< describes SetUpRecord::cells
    std::vector<NumberDescription> span; ///< describes SpanRecord::cells, the table's columns
    std::vector<NumberDescription> sample; ///< describes SampleRecord::cells
};

/// One visit of a sample. Its state lives no longer than the call that tells of it.
struct SampleVisit {
    std::int64_t x = 0;
    std::int64_t y = 0;
    SampleFate fate = SampleFate::Written;
    const void *state = nullptr;
};

/// Which states a step has: its primitive's, its span's where it has one, its sample's.
struct StatePlace {
    const ScanSettings &settings;
    std::size_t primitive = 0;
    std::optional<std::size_t> span = std::nullopt;
    std::size_t firstSpan = 0; ///< of the primitive
    const SampleVisit *visit = nullptr;

    StatePlace at(const SampleVisit &sample) const
    {
        return {settings, primitive, span, firstSpan, &sample};
    }
};

/// The states of a run in the kernel's own numbers: what the recorder keeps of its events, and what
/// a trace's records and words are read from.
class KernelStates {
public:
    virtual ~KernelStates() = default;

    virtual TraceNumbers numbers() const = 0;

    /// Keeps a set-up, or an empty one for a primitive of which nothing was computed.
    virtual void keepSetUp(const void *setUp) = 0;
    /// Keeps a span and says where it lies.
    virtual SpanPlace keepSpan(const void *span) = 0;
    /// The crossings of a polygon's row, which take memory; 0 for other spans.
    virtual std::size_t crossingsIn(const void *span) const = 0;
    /// Whether a level left 0 … 255.
    virtual bool isClamped(const void *sample) const = 0;

    /// What a kept sample takes, bytes; 0 where none is kept, since spans can be walked again.
    virtual std::size_t bytesOfSample() const = 0;
    virtual void keepSample(const void *sample) = 0;
    virtual const void *keptSample(std::size_t sample) const = 0;
    /// Calls the kernel's own loop again for one span.
    virtual void walkAgain(const StatePlace &place, Listener &listener) const = 0;

    /// Read what a record holds besides its cells.
    virtual void read(const StatePlace &place, SetUpRecord &record) const = 0;
    virtual void read(const StatePlace &place, SpanRecord &record) const = 0;
    virtual void read(const StatePlace &place, SampleRecord &record) const = 0;

    /// The numbers of a step; its words; how its numbers are described.
    virtual std::vector<Quantity> cells(const StatePlace &place) const = 0;
    virtual StepWords words(const StatePlace &place) const = 0;
    virtual std::vector<NumberDescription> descriptions(const StatePlace &place) const = 0;
};

} // namespace pixelplumb
