// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// Draws triangles (sample coordinates) in order by the plain kernel, column by column.
void drawColumns(std::span<const Triangle> triangles, const ScanSettings &settings,
                 FrameView frame);

/// The row of the table of methods for the assignment's column scan.
Method columnScanMethod();

} // namespace pixelplumb
