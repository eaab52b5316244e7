// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/coveragemask.h"
#include "core/frame/framebuffer.h"

#include <algorithm>

namespace pixelplumb {

/// A frame that begins transparent. Kernels write opaque pixels, so an opaque pixel was written,
/// even in the background's colour.
class WrittenFrame {
public:
    explicit WrittenFrame(const FrameSpec &spec)
        : m_frame(spec)
    {
        const FrameView window = view();
        for (std::int64_t y = window.firstRow; y < window.endRow(); ++y)
            std::fill_n(window.at(window.firstColumn, y), window.width, untouched);
    }

    /// The view to draw into.
    FrameView view() const { return m_frame.view(); }

    // (x, y) must lie inside the frame.
    bool isWritten(std::int64_t x, std::int64_t y) const { return *view().at(x, y) != untouched; }
    Colour colourAt(std::int64_t x, std::int64_t y) const { return unpacked(*view().at(x, y)); }

    CoverageMask coverage() const
    {
        CoverageMask coverage(m_frame.spec());
        const FrameView window = view();
        for (std::int64_t y = window.firstRow; y < window.endRow(); ++y) {
            for (std::int64_t x = window.firstColumn; x < window.endColumn(); ++x) {
                if (isWritten(x, y))
                    coverage.cover(x, y);
            }
        }
        return coverage;
    }

private:
    static constexpr QRgb untouched = 0; ///< alpha 0

    FrameBuffer m_frame;
};

} // namespace pixelplumb
