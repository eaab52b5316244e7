// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

#include <vector>

namespace pixelplumb {

/// The table's columns as the assignment names the numbers, in the order of ColumnCell.
std::vector<TraceColumn> columnScanColumns();
/// The same of a set-up, in the order of ColumnSetUpCell.
std::vector<TraceColumn> columnScanSetUpColumns();

} // namespace pixelplumb
