// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/picturereader.h"

#include "core/frame/framespec.h"
#include "core/scene/files/bmpfault.h"
#include "core/scene/files/pnmfault.h"

#include <cstdlib>

namespace pixelplumb {

PictureReader::PictureReader(const QByteArray &content)
    : m_bmpFault(bmpFault(content))
    , m_content(withSpacedBits(content))
    , m_buffer(&m_content)
    , m_reader(&m_buffer)
{
    constexpr int mostMegabytes = int(largestFrameArea * 8 >> 20); // two bytes per channel
    QImageReader::setAllocationLimit(mostMegabytes);
    if (PngPicture::isPng(content))
        m_png.emplace(content);
}

QSize PictureReader::size()
{
    if (m_png)
        return m_png->size();
    // Of a BMP whose lines stand from the top down, Qt tells a height below 0.
    const QSize size = m_reader.size();
    return {size.width(), std::abs(size.height())};
}

} // namespace pixelplumb
