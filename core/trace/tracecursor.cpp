// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/tracecursor.h"

namespace pixelplumb {

void TraceCursor::seek(std::size_t position)
{
    Q_ASSERT(position <= m_trace->stepCount());
    const PixelChanges &changes = m_trace->changes();
    const FrameView frame = m_frame.view();
    const std::size_t target = m_trace->samplesDoneAt(position);
    while (m_samplesDone < target) {
        const PixelChange &change = changes[m_samplesDone++];
        if (change.isWritten())
            *frame.at(change.x, change.y) = change.after;
    }
    while (m_samplesDone > target) {
        const PixelChange &change = changes[--m_samplesDone];
        *frame.at(change.x, change.y) = change.before;
    }
    m_position = position;
}

} // namespace pixelplumb
