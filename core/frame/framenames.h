// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <array>
#include <string_view>

namespace pixelplumb {

inline constexpr std::array allFrameOrigins = {FrameOrigin::BottomLeft, FrameOrigin::TopLeft};
inline constexpr std::array allPixelCentres = {PixelCentre::Integer, PixelCentre::Half};

/// The names in files: "bottom-left" and "top-left".
constexpr std::string_view nameOf(FrameOrigin origin)
{
    return origin == FrameOrigin::BottomLeft ? "bottom-left" : "top-left";
}

/// "integer" and "half"
constexpr std::string_view nameOf(PixelCentre centre)
{
    return centre == PixelCentre::Integer ? "integer" : "half";
}

} // namespace pixelplumb
