// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/colour.h"

#include <algorithm>

/// Rows of a frame whose alpha shows what was written: they begin transparent, and kernels write
/// opaque pixels, even in the background's colour. The loops have no branches, so compilers
/// vectorize them.
namespace pixelplumb {

inline constexpr QRgb opaque = 0xff000000;

inline void fillTransparent(FrameView rows, const Colour &background)
{
    const QRgb untouched = packed(background) & ~opaque;
    for (std::int64_t y = rows.firstRow; y < rows.endRow(); ++y)
        std::fill_n(rows.at(rows.firstColumn, y), rows.width, untouched);
}

inline void makeOpaque(QRgb *pixels, std::int32_t count)
{
    for (std::int32_t x = 0; x < count; ++x)
        pixels[x] |= opaque;
}

inline bool areSame(const QRgb *left, const QRgb *right, std::int32_t count)
{
    QRgb different = 0;
    for (std::int32_t x = 0; x < count; ++x)
        different |= left[x] ^ right[x];
    return different == 0;
}

} // namespace pixelplumb
