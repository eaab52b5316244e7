// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/strokestrip.h"

#include <span>

namespace pixelplumb {

/// A pixel whose square one quadrilateral of a stroke meets; ordered by column, then row.
struct StrokePixel {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t quad = 0;

    friend constexpr auto operator<=>(const StrokePixel &, const StrokePixel &) = default;
};

/// All of the frame, in order; among them may be some that are met in a line or a point alone.
std::vector<StrokePixel> strokePixels(std::span<const StrokeQuad> quads, const FrameView &frame);

} // namespace pixelplumb
