// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pixelplumb {

/// The rows [first, end) of a column.
struct RowRun {
    std::int64_t first = 0;
    std::int64_t end = 0;
};

} // namespace pixelplumb
