// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace pixelplumb {

/// At most `most` of the indices 0 … count − 1, ascending: the first, the last and others evenly
/// between them; `most` > 1.
inline std::vector<std::size_t> spreadOver(std::size_t count, std::size_t most)
{
    std::vector<std::size_t> indices;
    if (count <= most) {
        for (std::size_t i = 0; i < count; ++i)
            indices.push_back(i);
        return indices;
    }
    for (std::size_t i = 0; i < most; ++i)
        indices.push_back(i * (count - 1) / (most - 1));
    return indices;
}

} // namespace pixelplumb
