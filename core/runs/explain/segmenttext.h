// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <QString>

namespace pixelplumb {

/// Whether the segment of a triangle without an area passes through a sample (px), with the number
/// that decides: "its segment from (1, 1) to (9, 5) passes the sample by: (9 − 1)·(3 − 1) −
/// (5 − 1)·(6 − 1) = −4, not 0". No full stop.
QString segmentText(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
