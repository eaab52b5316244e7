// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/scene/result.h"

namespace pixelplumb {

inline constexpr int largestTextureSide = 4096; // texels

/// A picture as texels, by any format that Qt reads; where the picture is transparent is not
/// looked at. Its size is judged by its header, before anything is decoded.
Result<Texture> readTexture(const QString &path);

} // namespace pixelplumb
