// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/scene/text/result.h"

namespace pixelplumb {

inline constexpr int largestTextureSide = 4096; // texels

/// Reads a picture as texels; its transparency is ignored. The size is judged by the header, before
/// anything is decoded.
Result<Texture> readTexture(const QString &path);

} // namespace pixelplumb
