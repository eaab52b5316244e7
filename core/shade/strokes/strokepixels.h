// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/strokes/strokestrip.h"

#include <span>

namespace pixelplumb {

/// A pixel whose square meets one quadrilateral of a stroke; ordered by column, then row.
struct StrokePixel {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t quad = 0;

    friend constexpr auto operator<=>(const StrokePixel &, const StrokePixel &) = default;
};

/// All such pixels of the frame, in order; some may be met only in a line or a point.
std::vector<StrokePixel> strokePixels(std::span<const StrokeQuad> quads, const FrameView &frame);

} // namespace pixelplumb
