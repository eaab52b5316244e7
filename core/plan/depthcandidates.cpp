// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/depthcandidates.h"

#include "core/shade/triangleneeds.h"

#include <limits>

namespace pixelplumb {

namespace {

std::array<Attribute, 3> depthsOf(const Triangle &triangle, const TriangleAttributes &attributes)
{
    const auto &vertices = attributes.vertices;
    std::array<Attribute, 3> z = {vertices[0].z, vertices[1].z, vertices[2].z};
    if (doubledArea(triangle) == 0) {
        const std::array<int, 3> order = sortedByColumn(triangle);
        z[std::size_t(order[1])] = z[std::size_t(order[0])];
    }
    return z;
}

/// The w of the vertices, positive, as kernels use them, if areas end at the horizon of the
/// triangle's plane; else zeros.
std::array<Attribute, 3> horizonOf(const Triangle &triangle, const TriangleAttributes *attributes,
                                   const Appearance &appearance, const SampledFrame &where)
{
    std::array<Attribute, 3> w = {};
    if (where.antialiasingOf(triangle) != Antialiasing::Area
        || !hasHorizon(triangle, attributes, appearance))
        return w;
    for (std::size_t i = 0; i < 3; ++i)
        w[i] = std::max<Attribute>(1, attributes->vertices[i].w);
    return w;
}

/// Half a pixel's square times the slopes of the plane, rounded up; for a sliver a bound beyond
/// which no depth lies.
Attribute excessOf(const Triangle &triangle, const std::array<Attribute, 3> &z,
                   Antialiasing antialiasing)
{
    if (antialiasing != Antialiasing::Area)
        return 0;
    Int128 alongX = 0, alongY = 0; // times the doubled area
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &a = triangle.vertices[(i + 1) % 3].position;
        const LatticePoint &b = triangle.vertices[(i + 2) % 3].position;
        alongX += Int128(z[i]) * (b.y - a.y);
        alongY += Int128(z[i]) * (b.x - a.x);
    }
    const Int128 excess = ceilDivide<Int128>(halfPixel * (absolute(alongX) + absolute(alongY)),
                                             absolute(doubledArea(triangle)));
    return Attribute(std::min<Int128>(excess, 4 * largestAttribute));
}

Lattice marginOf(Antialiasing antialiasing)
{
    return antialiasing == Antialiasing::None ? 0 : halfPixel;
}

/// The triangle's bounding box, widened by a margin, clipped to the frame widened as much.
DepthBox boxWithin(const Triangle &triangle, const FrameView &frame, Lattice margin)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    const auto within = [margin](Lattice coordinate, std::int32_t first, std::int32_t count) {
        const Lattice fromFirst = coordinate - first * unitsPerPixel + margin;
        return std::int32_t(
            std::clamp<Lattice>(fromFirst, 0, (count - 1) * unitsPerPixel + 2 * margin));
    };
    return {within(left - margin, frame.firstColumn, frame.width),
            within(right + margin, frame.firstColumn, frame.width),
            within(low - margin, frame.firstRow, frame.height),
            within(high + margin, frame.firstRow, frame.height)};
}

/// Sets depths in levels of 0 … mostDepthLevel between the nearest and the farthest vertex; levels
/// are the depths' own units if there are enough levels.
void setDepthLevels(DepthCandidates &candidates)
{
    Attribute least = largestAttribute;
    Attribute most = -largestAttribute;
    for (const std::array<Attribute, 3> &z : candidates.z) {
        const auto [nearest, farthest] = std::ranges::minmax(z);
        least = std::min(least, nearest);
        most = std::max(most, farthest);
    }
    int shift = 0;
    while (((most - least) >> shift) >= mostDepthLevel)
        ++shift;
    const Attribute roundUp = (Attribute(1) << shift) - 1;
    for (std::size_t i = 0; i < candidates.boxes.size(); ++i) {
        DepthBox &box = candidates.boxes[i];
        const auto levelOf = [&](Attribute aboveLeast) {
            return std::int32_t(std::clamp<Attribute>(aboveLeast >> shift, -1, mostDepthLevel + 1));
        };
        box.nearest = levelOf(candidates.nearest(i) - least);
        box.farthest = levelOf(candidates.farthest(i) - least + roundUp);
    }
}

} // namespace

DepthCandidates depthCandidatesOf(const Primitives &primitives, const SampledFrame &where)
{
    const std::size_t count = primitives.triangles.size();
    const Lattice margin = marginOf(where.antialiasing);
    const auto sideOf = [margin](std::int32_t pixels) {
        return std::int32_t((pixels - 1) * unitsPerPixel + 2 * margin);
    };
    DepthCandidates candidates{
        sideOf(where.frame.width), sideOf(where.frame.height), {}, {}, {}, {}, {}};
    candidates.boxes.reserve(count);
    candidates.triangles.reserve(count);
    candidates.z.reserve(count);
    candidates.w.reserve(count);
    candidates.excess.reserve(count);
    auto next = primitives.attributes.begin();
    for (std::size_t i = 0; i < count; ++i) {
        const bool hasAttributes = next != primitives.attributes.end() && next->triangle == i;
        const TriangleAttributes *attributes = hasAttributes ? &*next++ : nullptr;
        const Triangle &triangle = primitives.triangles[i];
        const auto horizon = horizonOf(triangle, attributes, primitives.appearance, where);
        if (reachOf(triangle, where, horizon).isEmpty())
            continue;
        candidates.boxes.push_back(boxWithin(triangle, where.frame, margin));
        candidates.triangles.push_back(std::uint32_t(i));
        candidates.z.push_back(attributes ? depthsOf(triangle, *attributes)
                                          : std::array<Attribute, 3>{});
        candidates.w.push_back(horizon);
        candidates.excess.push_back(
            excessOf(triangle, candidates.z.back(), where.antialiasingOf(triangle)));
    }
    setDepthLevels(candidates);
    return candidates;
}

bool haveOneDepth(const Primitives &primitives)
{
    const std::vector<TriangleAttributes> &attributes = primitives.attributes;
    if (attributes.empty())
        return true;
    const Attribute depth
        = attributes.size() < primitives.triangles.size() ? 0 : attributes[0].vertices[0].z;
    return std::ranges::all_of(attributes, [depth](const TriangleAttributes &each) {
        return std::ranges::all_of(
            each.vertices, [depth](const VertexAttributes &vertex) { return vertex.z == depth; });
    });
}

bool areInOrder(const DepthCandidates &candidates)
{
    Attribute nearest = std::numeric_limits<Attribute>::max();
    for (std::size_t i = 0; i < candidates.z.size(); ++i) {
        if (candidates.farthest(i) > nearest)
            return false;
        nearest = candidates.nearest(i);
    }
    return true;
}

} // namespace pixelplumb
