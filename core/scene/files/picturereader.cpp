// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/picturereader.h"

#include "core/frame/framespec.h"
#include "core/scene/files/bmpfault.h"

namespace pixelplumb {

PictureReader::PictureReader(const QByteArray &content)
    : m_bmpFault(bmpFault(content))
    , m_content(content)
    , m_buffer(&m_content)
    , m_reader(&m_buffer)
{
    constexpr int mostMegabytes = int(largestFrameArea * 8 >> 20); // two bytes per channel
    QImageReader::setAllocationLimit(mostMegabytes);
    if (PngPicture::isPng(content))
        m_png.emplace(content);
}

} // namespace pixelplumb
