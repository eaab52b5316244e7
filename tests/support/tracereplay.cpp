// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/tracereplay.h"

#include "core/frame/framebuffer.h"

namespace pixelplumb {

QImage replayed(const ScanTrace &trace, const FrameSpec &frame)
{
    FrameBuffer buffer(frame);
    for (std::size_t i = 0; i < trace.sampleCount(); ++i) {
        const PixelChange &change = trace.changes()[i];
        if (change.isWritten())
            *buffer.view().at(change.x, change.y) = change.after;
    }
    return buffer.copy();
}

} // namespace pixelplumb
