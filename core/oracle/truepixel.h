// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/colour.h"

namespace pixelplumb::oracle {

/// Writes one pixel of a true picture; does nothing outside the frame.
inline void writeTruePixel(FrameView frame, std::int64_t x, std::int64_t y, const Colour &colour)
{
    if (!frame.contains(x, y))
        return;
    *frame.at(x, y) = packed(colour);
}

} // namespace pixelplumb::oracle
