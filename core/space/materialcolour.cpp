// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/materialcolour.h"

namespace pixelplumb {

Colour tinted(const Colour &colour, const Colour &tint)
{
    return {{tinted(colour.red(), tint.red()), tinted(colour.green(), tint.green()),
             tinted(colour.blue(), tint.blue())}};
}

const Material &materialOf(const Appearance &appearance, int material)
{
    static const Material white;
    const bool isThere = material >= 0 && std::size_t(material) < appearance.materials.size();
    return isThere ? appearance.materials[std::size_t(material)] : white;
}

} // namespace pixelplumb
