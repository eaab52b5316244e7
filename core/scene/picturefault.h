// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/bmpfault.h"
#include "core/scene/pngfault.h"

namespace pixelplumb {

/// Where a picture's file is broken that its decoder would complain of by itself, or take; empty of
/// a whole one and of what is neither a PNG nor a BMP.
inline QString pictureFault(const QByteArray &content)
{
    const QString fault = pngFault(content);
    return fault.isEmpty() ? bmpFault(content) : fault;
}

} // namespace pixelplumb
