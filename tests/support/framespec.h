// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

namespace pixelplumb {

/// A frame of this size; its first pixel is (firstColumn, firstRow).
inline FrameSpec frameOf(std::int32_t width, std::int32_t height, std::int32_t firstColumn = 0,
                         std::int32_t firstRow = 0)
{
    FrameSpec spec;
    spec.width = width;
    spec.height = height;
    spec.firstColumn = firstColumn;
    spec.firstRow = firstRow;
    return spec;
}

} // namespace pixelplumb
