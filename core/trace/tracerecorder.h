// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/scantrace.h"

#include <functional>

namespace pixelplumb {

/// Limits and company of a recording.
struct TraceOptions {
    /// Recording ends, and the trace says so, when this many pixels are recorded (16 bytes each).
    std::size_t pixelLimit = std::size_t(1) << 24;
    /// The same for columns (about 400 bytes each).
    std::size_t columnLimit = std::size_t(1) << 18;
    /// Called at every column with the columns entered so far; returning false cancels the
    /// recording.
    std::function<bool(std::size_t columnsEntered)> progress;
};

/// Thrown out of a kernel by the recorder when the recording is cancelled or its limit is reached;
/// the tracing function that started the kernel catches it. Kernels hold nothing that needs
/// undoing.
struct RecordingEnded {
    enum class Why { Cancelled, LimitReached } why;
};

/// A trace in the very numbers of one arithmetic.
template <class A>
class TypedTrace final : public ScanTrace {
public:
    explicit TypedTrace(const ScanSettings &settings)
        : ScanTrace(settings)
    {
    }

    SetUpRecord setUp(std::size_t triangle) const override;
    ColumnRecord column(std::size_t column) const override;
    std::vector<FragmentRecord> fragments(std::size_t column) const override;

private:
    template <class>
    friend class TraceRecorder;

    struct TypedSetUp {
        ColumnSetUp<A> setUp;
        std::optional<TriangleRejection> rejection;
    };
    std::vector<TypedSetUp> m_setUps;
    std::vector<ColumnState<A>> m_states;
};

/// The observer that writes a trace.
template <class A>
class TraceRecorder {
public:
    TraceRecorder(TypedTrace<A> &trace, const TraceOptions &options)
        : m_trace(&trace)
        , m_options(&options)
    {
    }

    void triangleBegun(const ColumnSetUp<A> &setUp)
    {
        m_trace->m_triangles.push_back({m_trace->stepCount(), m_trace->columnCount()});
        m_trace->m_setUps.push_back({setUp, std::nullopt});
    }
    void triangleRejected(TriangleRejection reason) { m_trace->m_setUps.back().rejection = reason; }
    void columnEntered(const ColumnState<A> &column)
    {
        if (m_options->progress && !m_options->progress(m_trace->columnCount()))
            throw RecordingEnded{RecordingEnded::Why::Cancelled};
        if (m_trace->columnCount() >= m_options->columnLimit)
            endAtLimit();
        m_trace->m_columns.push_back({m_trace->stepCount(), m_trace->pixelCount(),
                                      m_trace->triangleCount() - 1, column.x, column.half});
        m_trace->m_states.push_back(column);
    }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after,
                      const Fragment<A> &fragment)
    {
        if (m_trace->pixelCount() >= m_options->pixelLimit)
            endAtLimit();
        if (fragment.isClamped())
            m_trace->m_clampedPixels.push_back(m_trace->pixelCount());
        m_trace->m_pixels.append({std::int32_t(x), std::int32_t(y), before, after});
    }

private:
    [[noreturn]] void endAtLimit()
    {
        m_trace->m_cut = true;
        throw RecordingEnded{RecordingEnded::Why::LimitReached};
    }

    TypedTrace<A> *m_trace;
    const TraceOptions *m_options;
};

} // namespace pixelplumb
