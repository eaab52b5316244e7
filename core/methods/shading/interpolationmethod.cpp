// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationmethod.h"

namespace pixelplumb {

CarriedChannels carriedBy(const Primitives &primitives)
{
    CarriedChannels carried;
    const std::size_t written = primitives.triangles.size() - primitives.sources.size();
    for (const TriangleAttributes &attributes : primitives.attributes) {
        if (attributes.triangle >= written)
            break;
        for (const VertexAttributes &vertex : attributes.vertices) {
            carried.depth |= vertex.z != 0;
            carried.texture |= vertex.texture != std::array<Attribute, 2>{};
            carried.normal |= vertex.normal != std::array<Attribute, 3>{};
        }
    }
    return carried;
}

} // namespace pixelplumb
