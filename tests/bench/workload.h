// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <QString>

#include <span>
#include <vector>

namespace pixelplumb::bench {

struct FrameSize {
    int width = 1920;
    int height = 1080;

    friend bool operator==(const FrameSize &, const FrameSize &) = default;
};

/// What is to be drawn: triangles in their order on a black frame, y upward. All vertices are whole
/// pixels inside the frame, so that every renderer can take them without rounding or clipping.
struct Scene {
    FrameSize size;
    std::span<const Triangle> triangles;
};

/// Levels of a vertex lie in this range. No level is 0, so a pixel that is not black was written.
inline constexpr int darkestLevel = 32;
inline constexpr int brightestLevel = 250;

/// A named set of triangles, the same in every run and on every machine.
struct Workload {
    QString id; ///< "W2"
    QString title; ///< "of 1,000 px", said of its triangles
    FrameSize size;
    std::vector<Triangle> triangles;

    Scene scene() const { return {size, triangles}; }
};

/// Whether the workloads are those to be quoted, or short ones that show that all works.
enum class Extent { Full, Quick };

/// The six workloads of the peers' comparison and three more: a mesh, overdraw, and a large frame.
std::vector<Workload> standardWorkloads(Extent extent);

/// Triangles of about that area in px at random places of a frame; they may overlap.
std::vector<Triangle> scatteredTriangles(FrameSize size, std::size_t count, int area,
                                         std::uint64_t seed);

/// Each triangle in the colour of its first vertex, for renderers without smooth colour.
std::vector<Triangle> flattened(std::span<const Triangle> triangles);

/// A vertex in whole pixels, y upward.
struct PixelPoint {
    int x = 0;
    int y = 0;
};

constexpr PixelPoint pixelOf(const Vertex &vertex)
{
    return {int(vertex.position.x / unitsPerPixel), int(vertex.position.y / unitsPerPixel)};
}

/// The samples inside, each triangle counted by itself, under the half-open rule: every sample of a
/// mesh once.
std::int64_t coveredSamples(std::span<const Triangle> triangles);

} // namespace pixelplumb::bench
