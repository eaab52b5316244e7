// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pixelplumb {

struct TracedScene;

/// For each cell of a span's primitive (SpanRecord::cells): whether all of its spans that have it
/// agree, but for rounding, and an earlier span than this one already has it.
std::vector<bool> constantNumbersBefore(const TracedScene &traced, std::size_t span);

} // namespace pixelplumb
