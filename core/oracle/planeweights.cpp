// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/planeweights.h"

namespace pixelplumb::oracle {

PlaneWeights barycentricWeights(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const LatticePoint sample = latticePixel(x, y);
    const int turn = doubledArea(triangle) < 0 ? -1 : 1;
    PlaneWeights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        weights.parts[i] = turn
            * doubledArea(sample, triangle.vertices[(i + 1) % 3].position,
                          triangle.vertices[(i + 2) % 3].position);
        weights.whole += weights.parts[i];
    }
    return weights;
}

PlaneWeights segmentWeights(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const std::array<int, 3> order = sortedByColumn(triangle);
    const auto first = std::size_t(order[0]);
    const auto last = std::size_t(order[2]);
    const LatticePoint &from = triangle.vertices[first].position;
    const LatticePoint &to = triangle.vertices[last].position;
    const LatticePoint sample = latticePixel(x, y);
    PlaneWeights weights;
    if (from == to) {
        weights.parts[first] = 1;
    } else if (from.x == to.x) {
        weights.parts[first] = to.y - sample.y;
        weights.parts[last] = sample.y - from.y;
    } else {
        weights.parts[first] = to.x - sample.x;
        weights.parts[last] = sample.x - from.x;
    }
    weights.whole = weights.parts[first] + weights.parts[last];
    return weights;
}

PlaneWeights perspectiveWeights(const PlaneWeights &barycentric,
                                const std::array<VertexAttributes, 3> &vertices)
{
    PlaneWeights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        weights.parts[i] = barycentric.parts[i] * vertices[(i + 1) % 3].w * vertices[(i + 2) % 3].w;
        weights.whole += weights.parts[i];
    }
    return weights;
}

std::uint8_t byteOf(const WideFraction &level, ByteRounding rounding)
{
    const BigInteger byte = rounding == ByteRounding::Nearest ? level.nearest() : level.floor();
    return byte < 0 ? 0 : byte > 255 ? 255 : byte.convert_to<std::uint8_t>();
}

} // namespace pixelplumb::oracle
