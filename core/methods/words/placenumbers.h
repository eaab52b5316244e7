// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

/// Where a span or a pixel lies: the numbers with which the tables of several methods begin.
namespace pixelplumb {

/// The triangle's index in drawing order.
NumberDescription triangleNumber();

/// The x of a scanned column; the formula says how it follows from the previous one.
NumberDescription scannedNumber(const QString &formula = {});
/// Between which two edges of its triangle it lies.
NumberDescription halfNumber();
/// How many of its samples are written.
NumberDescription columnPixelsNumber();

/// The one pixel of a step.
NumberDescription pixelX();
NumberDescription pixelY();

} // namespace pixelplumb
