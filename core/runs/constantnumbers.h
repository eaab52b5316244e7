// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pixelplumb {

struct TracedScene;

/// Of the cells of a span's primitive (SpanRecord::cells): whether they are the same in all of its
/// spans that have them, but for rounding, and an earlier span than this one has them already.
std::vector<bool> constantNumbersBefore(const TracedScene &traced, std::size_t span);

} // namespace pixelplumb
