// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/colour.h"

namespace pixelplumb {

/// What colours a pixel of a shape that has one colour.
struct FlatSample {
    Colour colour;
};

/// Writes one pixel if the frame contains it.
template <class Observer>
void writeFlat(std::int64_t x, std::int64_t y, const Colour &colour, FrameView frame,
               Observer observer)
{
    if (!frame.contains(x, y))
        return;
    QRgb *pixel = frame.at(x, y);
    observer.pixelWritten(x, y, *pixel, packed(colour), FlatSample{colour});
    *pixel = packed(colour);
}

} // namespace pixelplumb
