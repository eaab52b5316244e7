// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/appearance.h"

namespace pixelplumb {

Texture checkerTexture()
{
    constexpr std::int32_t side = 8;
    Texture checker{"checker", side, side, {}};
    for (std::int32_t j = 0; j < side; ++j) {
        for (std::int32_t i = 0; i < side; ++i) {
            const std::uint8_t level = (i + j) % 2 == 0 ? 255 : 0;
            checker.texels.push_back({{level, level, level}});
        }
    }
    return checker;
}

} // namespace pixelplumb
