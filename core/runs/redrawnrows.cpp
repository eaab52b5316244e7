// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/redrawnrows.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// How many rows rounded increments may leave a triangle's bounding box by, amply: float32 adds
/// some 2^13 columns of at most 2^12 px with errors of at most 2^-13 px each.
constexpr std::int64_t rowsOfError = 4;
constexpr Lattice largestOfSmallError = (Lattice(1) << 12) * unitsPerPixel;

/// More triangles are not kept for comparison: each takes 72 bytes.
constexpr std::size_t mostCompared = std::size_t(1) << 20;

bool staysNearItsBox(const Triangle &triangle)
{
    return std::ranges::all_of(triangle.vertices, [](const Vertex &vertex) {
        return absolute(vertex.position.x) <= largestOfSmallError
            && absolute(vertex.position.y) <= largestOfSmallError;
    });
}

bool differInTrianglesAlone(const Scene &scene, const Scene &other)
{
    return scene.frame == other.frame && scene.settings == other.settings
        && scene.method == other.method && scene.shapes == other.shapes
        && scene.attributes == other.attributes && scene.appearance == other.appearance
        && scene.triangles.size() == other.triangles.size();
}

} // namespace

FrameRows allRowsOf(const FrameSpec &frame)
{
    return {frame.firstRow, std::int64_t(frame.firstRow) + frame.height};
}

FrameRows rowsReachedBy(const Triangle &triangle)
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [low, high] = std::minmax({a.position.y, b.position.y, c.position.y});
    return {floorPixel(low) - rowsOfError, ceilPixel(high) + rowsOfError + 1};
}

Triangle onSamples(Triangle triangle, Lattice offset)
{
    for (Vertex &vertex : triangle.vertices)
        vertex.position = {vertex.position.x - offset, vertex.position.y - offset};
    return triangle;
}

bool isDrawnByRows(const Scene &scene, const Method &method)
{
    // These reach any row: what wraps, and edges that run past their ends.
    const bool leaves
        = scene.settings.arithmetic == Arithmetic::Fixed16 || !scene.settings.isRight();
    return method.hasFastKernels && !leaves && scene.shapes.empty() && !mayCallForEffects(scene)
        && scene.triangles.size() <= mostCompared
        && std::ranges::all_of(scene.triangles, staysNearItsBox);
}

FrameRows rowsThatDiffer(const Scene &scene, const Scene &other)
{
    const FrameRows all = allRowsOf(scene.frame);
    if (!differInTrianglesAlone(scene, other))
        return all;
    FrameRows rows = {all.end, all.first};
    const Lattice offset = sampleOffset(scene.frame);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        if (scene.triangles[i] == other.triangles[i])
            continue;
        for (const Triangle &triangle : {scene.triangles[i], other.triangles[i]}) {
            const FrameRows reached = rowsReachedBy(onSamples(triangle, offset));
            rows = {std::min(rows.first, reached.first), std::max(rows.end, reached.end)};
        }
    }
    return {std::max(rows.first, all.first), std::min(rows.end, all.end)};
}

} // namespace pixelplumb
