// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/picturereader.h"

#include "core/frame/framespec.h"
#include "core/scene/files/bmpfault.h"
#include "core/scene/files/pngfault.h"

namespace pixelplumb {

namespace {

/// Enough for the largest picture with two bytes per channel.
constexpr int mostMegabytes = int(largestFrameArea * 8 >> 20);

QString faultOf(const QByteArray &content)
{
    const QString fault = pngFault(content);
    return fault.isEmpty() ? bmpFault(content) : fault;
}

} // namespace

PictureReader::PictureReader(const QByteArray &content)
    : m_fault(faultOf(content))
    , m_content(plainPng(content))
    , m_buffer(&m_content)
    , m_reader(&m_buffer)
{
    QImageReader::setAllocationLimit(mostMegabytes);
}

} // namespace pixelplumb
