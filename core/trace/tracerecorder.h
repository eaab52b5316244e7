// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/jobprogress.h"
#include "core/trace/scantrace.h"

namespace pixelplumb {

/// What a recording keeps.
enum class TraceDetail {
    Samples, ///< every sample
    Spans, ///< only the numbers of the spans
    Rejections, ///< only those; the first pixel that is written cancels the recording
};

/// Limits, progress and detail of a recording.
struct TraceOptions {
    /// Recording ends, and the trace is marked as cut, after this many samples (16 bytes each).
    std::size_t sampleLimit = std::size_t(1) << 24;
    /// The limit for spans (about 400 bytes each; four crossings of a polygon's row count as one).
    std::size_t spanLimit = std::size_t(1) << 18;
    /// Receives at every span the number entered so far; the total is unknown.
    ProgressListener progress;
    TraceDetail detail = TraceDetail::Samples;
};

/// What a recording does with each primitive.
struct RecordedScan {
    std::function<bool(std::size_t primitive)> draws; ///< whether it is of the method's kinds
    std::function<void(std::size_t primitive, Listener &)> scan;
};

/// Records what `scan` announces of each primitive that the method draws; the others are recorded
/// as rejected. Null when options.progress cancelled it.
std::unique_ptr<ScanTrace> recordTrace(std::size_t primitiveCount, const ScanSettings &settings,
                                       const TraceOptions &options, const RecordedScan &scan,
                                       std::unique_ptr<KernelStates> states);

} // namespace pixelplumb
