// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/frame/frameview.h"

#include <QImage>

#include <memory>

namespace pixelplumb {

/// The frame's memory (Format_RGB32) and the QImage that shows it. Rows are padded so that a walk
/// down a column does not hit the same few cache sets (resources/numerics.md, 2.4: 1.8 instead of
/// 10.6 ns per pixel); each begins on a cache line.
class FrameBuffer {
public:
    explicit FrameBuffer(const FrameSpec &spec);

    const FrameSpec &spec() const { return m_spec; }
    FrameView view() const { return m_view; }

    /// Shares this buffer's memory: it also shows later drawing, and must not outlive the buffer.
    QImage image() const;
    /// An independent picture, without padding.
    QImage copy() const { return image().copy(); }

    void clear();

private:
    struct LineAlignedDelete {
        void operator()(QRgb *pixels) const;
    };

    FrameSpec m_spec;
    std::ptrdiff_t m_lineLength = 0; ///< pixels, padding included
    std::unique_ptr<QRgb[], LineAlignedDelete> m_pixels;
    FrameView m_view;
};

/// The line of a picture (0 at the top) that shows a row of the frame.
int pictureLine(const FrameSpec &spec, std::int64_t row);
/// The row of the frame that a line of its picture shows; the inverse of pictureLine.
std::int64_t rowOfPictureLine(const FrameSpec &spec, int line);

} // namespace pixelplumb
