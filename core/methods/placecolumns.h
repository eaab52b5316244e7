// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

/// Where a span or a pixel lies: the columns with which the tables of several methods begin.
namespace pixelplumb {

/// The triangle's place in drawing order.
TraceColumn triangleColumn();

/// The x of a scanned column; the formula says how it comes from the one before.
TraceColumn scannedColumn(const QString &formula = {});
/// Between which two edges of its triangle it lies.
TraceColumn halfColumn();
/// How many of its samples are written.
TraceColumn columnPixelsColumn();

/// The one pixel of a step.
TraceColumn pixelX();
TraceColumn pixelY();

} // namespace pixelplumb
