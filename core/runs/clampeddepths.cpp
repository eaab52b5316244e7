// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/clampeddepths.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString clampedDepthsText(const Primitives &primitives)
{
    const Appearance &appearance = primitives.appearance;
    if (appearance.depthFormat == DepthFormat::Exact || appearance.depth == DepthUse::Off)
        return {};
    std::ptrdiff_t clamped = 0;
    for (const TriangleAttributes &attributes : primitives.attributes) {
        clamped += std::ranges::count_if(attributes.vertices, [](const VertexAttributes &vertex) {
            return vertex.z < 0 || vertex.z > attributeOne;
        });
    }
    if (clamped == 0)
        return {};
    return (clamped == 1 ? u"%1 vertex has a depth outside 0 … 1, which %2 bits keep "
                           "as 0 or 1"_s
                         : u"%1 vertices have a depth outside 0 … 1, which %2 bits "
                           "keep as 0 or 1"_s)
        .arg(clamped)
        .arg(int(appearance.depthFormat));
}

} // namespace pixelplumb
