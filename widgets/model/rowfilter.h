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
    Errors, ///< a pixel of the span's column or row differs from the truth, or one of its samples
};

/// Those spans, ascending; of All every one.
std::vector<std::size_t> spansOf(const TracedScene &traced, RowFilter filter);

} // namespace pixelplumb
