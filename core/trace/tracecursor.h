// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/trace/scantrace.h"

namespace pixelplumb {

/// A frame at one position of a trace that can be moved either way: forward it writes each change's
/// `after`, backward its `before`. The trace must outlive the cursor.
class TraceCursor {
public:
    TraceCursor(const ScanTrace &trace, const FrameSpec &spec)
        : m_trace(&trace)
        , m_frame(spec)
    {
    }

    std::size_t position() const { return m_position; }
    const FrameBuffer &frame() const { return m_frame; }

    /// Goes to a position in 0 … stepCount(); costs one write for each sample in between.
    void seek(std::size_t position);

private:
    const ScanTrace *m_trace;
    FrameBuffer m_frame;
    std::size_t m_position = 0;
    std::size_t m_samplesDone = 0;
};

} // namespace pixelplumb
