// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/effect.h"

namespace pixelplumb {

std::string_view nameOf(Effect effect)
{
    static constexpr std::array<std::string_view, allEffects.size()> names
        = {"smooth colour", "clipping", "depth",    "perspective",
           "texture",       "light",    "blending", "antialiasing"};
    return names[std::size_t(effect)];
}

} // namespace pixelplumb
