// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/materialcolour.h"

namespace pixelplumb {

const Material &materialOf(const Appearance &appearance, int material)
{
    static const Material white;
    const bool isThere = material >= 0 && std::size_t(material) < appearance.materials.size();
    return isThere ? appearance.materials[std::size_t(material)] : white;
}

} // namespace pixelplumb
