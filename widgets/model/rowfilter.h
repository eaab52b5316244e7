// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pixelplumb {

struct TracedScene;

/// Which spans of a run are worth a look.
enum class RowFilter {
    All,
    Ties, ///< a sample lies exactly on an edge
    Clamps, ///< a level left 0 … 255
    Errors, ///< a pixel of the span's column or row, or one of its samples, differs from the truth
};

/// The spans that pass the filter, ascending.
std::vector<std::size_t> spansOf(const TracedScene &traced, RowFilter filter);

} // namespace pixelplumb
