// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/segmentstudy.h"

#include "core/measure/stopwatch.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int runs = 3;

double inPixels(Lattice units) { return double(units) / double(unitsPerPixel); }

const Solid *firstOf(const Scene &scene, SolidKind kind)
{
    const auto found = std::ranges::find(scene.solids, kind, &Solid::kind);
    return found == scene.solids.end() ? nullptr : &*found;
}

double timeOfProjection(const Scene &scene)
{
    double least = 0;
    for (int run = 0; run < runs; ++run) {
        const Stopwatch watch;
        const ProjectedSolids projected = projectedSolids(scene);
        const double time = watch.elapsed().thread;
        least = run == 0 ? time : std::min(least, time);
    }
    return least;
}

} // namespace

std::optional<Solid> studiedSolid(const Scene &scene)
{
    for (const Solid &solid : scene.solids) {
        if (!solid.isHidden && (solid.kind == SolidKind::Sphere || solid.kind == SolidKind::Patch))
            return solid;
    }
    return std::nullopt;
}

Solid exampleSolid()
{
    Solid sphere;
    sphere.kind = SolidKind::Sphere;
    sphere.corners.resize(1);
    return sphere;
}

std::optional<Surface> surfaceOf(SurfaceKind kind, const Scene &scene)
{
    if (kind == SurfaceKind::Line || kind == SurfaceKind::Circle) {
        const PrimitiveKind shape
            = kind == SurfaceKind::Line ? PrimitiveKind::Line : PrimitiveKind::Circle;
        const auto found = std::ranges::find(scene.shapes, shape, &Shape::kind);
        if (found == scene.shapes.end())
            return std::nullopt;
        const LatticePoint &a = found->vertices[0].position;
        const LatticePoint &b = found->vertices[1].position;
        return Surface{kind,
                       {{{inPixels(a.x), inPixels(a.y), 0}, {inPixels(b.x), inPixels(b.y), 0}, {}}},
                       inPixels(absolute(b.x - a.x))};
    }
    const Solid *solid
        = firstOf(scene, kind == SurfaceKind::Plane ? SolidKind::Plane : SolidKind::Sphere);
    if (!solid)
        return std::nullopt;
    Surface surface{kind, {}, solid->radius};
    for (std::size_t i = 0; i < std::min(solid->corners.size(), surface.points.size()); ++i)
        surface.points[i] = solid->corners[i].position;
    return surface;
}

Surface exampleOf(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::Line:
    case SurfaceKind::Circle:
        return {kind, {{{1, 2, 0}, {7, 5, 0}, {}}}, 2};
    case SurfaceKind::Plane:
        return {kind, {{{0, 0, 0}, {2, 0, 1}, {0, 3, 1}}}, 1};
    case SurfaceKind::Sphere:
        break;
    }
    return {kind, {}, 1};
}

std::vector<SegmentFigure> studySegments(const Solid &solid, const Scene &scene,
                                         const ProgressListener &listener)
{
    std::vector<std::array<int, 2>> all;
    for (int along = 2; along <= 64; along *= 2)
        all.push_back({2 * along, along});
    if (std::ranges::find(all, solid.segments) == all.end())
        all.push_back(solid.segments);
    std::ranges::sort(all, {}, [](const auto &segments) { return segments[0] * segments[1]; });
    Scene alone = scene;
    alone.triangles.clear();
    alone.shapes.clear();
    alone.solids = {solid};
    std::vector<SegmentFigure> figures;
    for (const auto &segments : all) {
        if (!goesOn(listener,
                    {JobPhase::Measuring, std::int64_t(figures.size()), std::int64_t(all.size())}))
            return {};
        alone.solids[0].segments = segments;
        const double distance = solid.kind == SolidKind::Sphere
            ? sphereDistance(solid.radius, segments)
            : patchDistance(alone.solids[0]);
        figures.push_back(
            {segments, faceCount(alone.solids[0]), distance, timeOfProjection(alone)});
    }
    return figures;
}

} // namespace pixelplumb
