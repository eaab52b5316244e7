// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"

#include <span>

namespace pixelplumb {

/// Draws triangles (sample coordinates) in order by the plain kernel, column by column.
void drawColumns(std::span<const Triangle> triangles, const ScanSettings &settings,
                 FrameView frame);

} // namespace pixelplumb
