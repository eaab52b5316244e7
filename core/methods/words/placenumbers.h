// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

/// The descriptions of numbers, and those with which the tables of several methods begin: where a
/// span or a pixel lies.
namespace pixelplumb {

/// A number shown alone, or next to the exact one.
NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula = {},
                              NumberGroup group = NumberGroup::Position);
NumberDescription comparedNumber(const QString &id, const QString &title, const QString &unit,
                                 const QString &toolTip, const QString &formula = {},
                                 NumberGroup group = NumberGroup::Position);

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
