// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/rowwriter.h"
#include "core/trace/tracedscene.h"

#include <functional>

namespace pixelplumb {

/// A row a column of the scan, or a row a written pixel.
enum class TraceLevel { Column, Pixel };

struct TraceExportOptions {
    TraceLevel level = TraceLevel::Column;
    TableFormat format = TableFormat::Csv;
    /// Called now and then with the share of the rows that is done, 0 … 1; returning false ends the
    /// export.
    std::function<bool(double done)> progress;
};

/// Writes the numbers that the kernel used, with the exact ones and the errors beside them.
///
/// Column level: "step" (counted from 1, as in the window), then each of the method's trace columns
/// under its id; where there is an exact value, "<id>_exact" and "<id>_error" (used − exact)
/// follow. Pixel level: "step", "triangle", "x", "y"; for R, G and B the used value, "_exact",
/// "_error", "_level" (rounded, before clamping) and "_byte"; "clamped", "before" and "after".
/// False when the device refused to take it or the progress function ended it.
bool exportTrace(const TracedScene &traced, const TraceExportOptions &options, QIODevice &device);

} // namespace pixelplumb
