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

/// The input of a renderer: triangles in drawing order on a black frame, y upward. All vertices are
/// on whole pixels inside the frame, so every renderer can take them without rounding or clipping.
struct Scene {
    FrameSize size;
    std::span<const Triangle> triangles;
};

/// The range of vertex levels. No level is 0, so every pixel that is not black was written.
inline constexpr int darkestLevel = 32;
inline constexpr int brightestLevel = 250;

/// A named set of triangles, the same in every run and on every machine.
struct Workload {
    QString id; ///< "W2"
    QString title; ///< "of 1,000 px", describing its triangles
    FrameSize size;
    std::vector<Triangle> triangles;

    Scene scene() const { return {size, triangles}; }
};

/// Whether to run the full workloads, whose results may be quoted, or short ones that only show
/// that everything works.
enum class Extent { Full, Quick };

/// The six workloads of the peers' comparison and three more: a mesh, overdraw, and a large frame.
std::vector<Workload> standardWorkloads(Extent extent);

/// Triangles of about `area` px at random places in the frame; they may overlap.
std::vector<Triangle> scatteredTriangles(FrameSize size, std::size_t count, int area,
                                         std::uint64_t seed);

/// Each triangle in the colour of its first vertex, for renderers without smooth colour.
std::vector<Triangle> flattened(std::span<const Triangle> triangles);

/// A vertex on whole pixels, y upward.
struct PixelPoint {
    int x = 0;
    int y = 0;
};

constexpr PixelPoint pixelOf(const Vertex &vertex)
{
    return {int(vertex.position.x / unitsPerPixel), int(vertex.position.y / unitsPerPixel)};
}

/// The samples inside, counted triangle by triangle under the half-open rule: each sample of a mesh
/// counts once.
std::int64_t coveredSamples(std::span<const Triangle> triangles);

} // namespace pixelplumb::bench
