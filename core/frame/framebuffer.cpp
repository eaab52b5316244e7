// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"

#include <algorithm>
#include <new>

namespace pixelplumb {

namespace {

constexpr std::ptrdiff_t pixelsPerCacheLine = 16;
constexpr std::align_val_t cacheLine{pixelsPerCacheLine * sizeof(QRgb)};

/// An odd number of cache lines: consecutive rows then visit every set of a power-of-two cache.
std::ptrdiff_t lineLengthFor(std::int32_t width)
{
    const std::ptrdiff_t cacheLines = (width + pixelsPerCacheLine - 1) / pixelsPerCacheLine;
    return (cacheLines | 1) * pixelsPerCacheLine;
}

} // namespace

void FrameBuffer::LineAlignedDelete::operator()(QRgb *pixels) const
{
    ::operator delete[](pixels, cacheLine);
}

FrameBuffer::FrameBuffer(const FrameSpec &spec)
    : m_spec(spec)
    , m_lineLength(lineLengthFor(spec.width))
    , m_pixels(new (cacheLine) QRgb[std::size_t(m_lineLength * spec.height)])
    , m_view(windowOf(spec))
{
    Q_ASSERT(spec.width >= 1 && spec.height >= 1);
    const bool upward = spec.origin == FrameOrigin::BottomLeft;
    m_view.base = m_pixels.get() + (upward ? (spec.height - 1) * m_lineLength : 0);
    m_view.stride = upward ? -m_lineLength : m_lineLength;
    clear();
}

QImage FrameBuffer::image() const
{
    return QImage(reinterpret_cast<uchar *>(m_pixels.get()), m_spec.width, m_spec.height,
                  qsizetype(m_lineLength) * qsizetype(sizeof(QRgb)), QImage::Format_RGB32);
}

void FrameBuffer::clear()
{
    std::fill_n(m_pixels.get(), m_lineLength * m_spec.height, packed(m_spec.background));
}

int pictureLine(const FrameSpec &spec, std::int64_t row)
{
    const std::int64_t fromFirst = row - spec.firstRow;
    return int(spec.origin == FrameOrigin::BottomLeft ? spec.height - 1 - fromFirst : fromFirst);
}

std::int64_t rowOfPictureLine(const FrameSpec &spec, int line)
{
    return spec.firstRow
        + (spec.origin == FrameOrigin::BottomLeft ? std::int64_t(spec.height) - 1 - line : line);
}

} // namespace pixelplumb
