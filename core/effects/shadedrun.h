// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/coveredstrip.h"
#include "core/effects/edgepixels.h"
#include "core/effects/shadedscan.h"
#include "core/effects/shadedtable.h"
#include "core/effects/triangleneeds.h"

#include <type_traits>

namespace pixelplumb {

/// The buffer and the lights that the triangles of one picture share: there is memory only for what
/// the plan runs.
template <class N>
struct ShadedSurroundings {
    ShadedSurroundings(const EffectPlan &plan, const Appearance &ofScene, const FrameView &frame)
        : appearance(ofScene)
        , lighting(ofScene)
        , depths(frame, depthTestOf(plan))
    {
    }

    static DepthTest depthTestOf(const EffectPlan &plan)
    {
        for (const EffectBatch &batch : plan.batches) {
            if (batch.effects.depth != DepthTest::None)
                return batch.effects.depth;
        }
        return DepthTest::None;
    }

    const Appearance &appearance;
    Lighting<typename N::Real> lighting;
    DepthBuffer<N> depths;
};

/// Draws shaded triangles one by one. An observer that reads numbers hears the kernel that takes
/// its effects when it runs; one that does not gets the kernel that was compiled for them. Both are
/// the same text.
template <InterpolationForm Form, class N, class A, class Observer>
class ShadedRun {
public:
    using Column = BoundedColumn<N, A>;

    ShadedRun(const Primitives &primitives, const ScanSettings &settings, Observer observer)
        : m_primitives(primitives)
        , m_settings(settings)
        , m_observer(observer)
    {
    }

    /// One sample a pixel.
    void draw(std::size_t index, const EffectSet &effects, FrameView frame,
              ShadedSurroundings<N> &surroundings)
    {
        drawColumns(triangleAt(index), effects, frame, surroundings,
                    [](const Column &column, const auto &shadeRun) {
                        shadeRun(RowRun{column.firstDrawn, column.endDrawn});
                    });
    }

    /// The same in some of the pixels, as a sample sees the triangle. `afterRuns` is called with
    /// each column after its runs, for what else is drawn in it.
    template <class AfterRuns>
    void draw(std::size_t index, const EffectSet &effects, FrameView frame,
              ShadedSurroundings<N> &surroundings, const EdgePixels &edges, bool ofEdges,
              const LatticePoint &sample, const AfterRuns &afterRuns)
    {
        // A segment has its pixels whole: each of their samples as it is at the pixel's own.
        const Triangle &triangle = m_primitives.triangles[index];
        const Triangle moved = doubledArea(triangle) == 0 ? triangle : seenFrom(triangle, sample);
        drawColumns({moved, m_primitives.attributesOf(index)}, effects, frame, surroundings,
                    [&](const Column &column, const auto &shadeRun) {
                        if (column.firstDrawn < column.endDrawn)
                            edges.forEachRun(column.x, {column.firstDrawn, column.endDrawn},
                                             ofEdges, shadeRun);
                        afterRuns(column);
                    });
    }

    /// α times the exact area of the triangle in each pixel's square. A segment, which has none, is
    /// drawn as without.
    void drawAreas(std::size_t index, const EffectSet &effects, FrameView frame,
                   ShadedSurroundings<N> &surroundings);

private:
    /// What shades a run with the effects, which live as long. The table's kernels are compiled
    /// only where they are asked for: not for an observer.
    auto shaderFor(const EffectSet &effects) const
    {
        if constexpr (std::is_same_v<Observer, NullObserver>) {
            return [kernel = ShadeTable<Form, N>::kernelFor(effects),
                    &effects](const ShadedSetUp<N> &setUp, const Column &column, const RowRun &run,
                              const ShadedSurface<N> &surface, FrameView frame) {
                kernel(setUp, column, run, effects, surface, frame);
            };
        } else {
            return [this, &effects](const ShadedSetUp<N> &setUp, const Column &column,
                                    const RowRun &run, const ShadedSurface<N> &surface,
                                    FrameView frame) {
                shadeColumn<Form>(setUp, column, run, effects, surface, frame, m_observer);
            };
        }
    }

    ShadedTriangle triangleAt(std::size_t index) const
    {
        return {m_primitives.triangles[index], m_primitives.attributesOf(index)};
    }

    /// What the triangle's samples are shaded with.
    ShadedSurface<N> surfaceOf(const ShadedTriangle &triangle,
                               ShadedSurroundings<N> &surroundings) const
    {
        const int material = triangle.attributes ? triangle.attributes->material : noMaterial;
        return {&surroundings.lighting,
                &materialOf(surroundings.appearance, material),
                &surroundings.depths,
                greatestDepthLevel(surroundings.appearance.depthFormat),
                m_settings.rounding,
                triangle.triangle.vertices[0].colour,
                nullptr};
    }

    /// Announces the triangle; false where nothing of it is drawn.
    bool begins(const ShadedTriangle &triangle, const ShadedSetUp<N> &setUp)
    {
        if constexpr (readsNumbers<Observer>) {
            ShadedSetUpRead<N> read{setUp, triangle.triangle.vertices, {}, noMaterial};
            if (triangle.attributes) {
                read.attributes = triangle.attributes->vertices;
                read.material = triangle.attributes->material;
            }
            m_observer.primitiveBegun(read);
        }
        const bool isDrawn = !setUp.zeroArea || m_settings.fillRule == FillRule::Closed;
        if (!isDrawn)
            m_observer.primitiveRejected(PrimitiveRejection::ZeroArea);
        return isDrawn;
    }

    /// Calls fill(column, shadeRun) for each column.
    template <class Fill>
    void drawColumns(const ShadedTriangle &triangle, const EffectSet &effects, FrameView frame,
                     ShadedSurroundings<N> &surroundings, const Fill &fill)
    {
        const ShadedSetUp<N> setUp = shadedSetUpOf<Form, N>(triangle, effects);
        if (!begins(triangle, setUp))
            return;
        const ShadedSurface<N> surface = surfaceOf(triangle, surroundings);
        const auto shadeRun = shaderFor(effects);
        const auto fillColumn = [&](const Column &column) {
            m_observer.spanEntered(column);
            fill(column, [&](const RowRun &run) { shadeRun(setUp, column, run, surface, frame); });
        };
        ShadedScan<Form, N, A, decltype(fillColumn)> scan(triangle.triangle, setUp,
                                                          m_settings.fillRule, frame, fillColumn);
        if (!scan.run())
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
    }

    const Primitives &m_primitives;
    ScanSettings m_settings;
    Observer m_observer;
};

template <InterpolationForm Form, class N, class A, class Observer>
void ShadedRun<Form, N, A, Observer>::drawAreas(std::size_t index, const EffectSet &effects,
                                                FrameView frame,
                                                ShadedSurroundings<N> &surroundings)
{
    const ShadedTriangle triangle = triangleAt(index);
    if (doubledArea(triangle.triangle) == 0)
        return draw(index, effects, frame, surroundings);
    // Where nothing that is divided by w differs, samples beyond the horizon have it too.
    EffectSet needed = effects;
    needed.perspective = effects.perspective
        && needsOf(triangle.triangle, triangle.attributes, surroundings.appearance)
               .effects.perspective;
    EffectSet covering = needed;
    covering.blending = true;
    const ShadedSetUp<N> setUp = shadedSetUpOf<Form, N>(triangle, covering);
    if (!begins(triangle, setUp))
        return;
    const ShadedSurface<N> whole = surfaceOf(triangle, surroundings);
    const auto shadeRun = shaderFor(needed);
    std::array<LatticePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = setUp.vertices[std::size_t(setUp.order[i])].position;
    const auto ignore = [](const Column &) {};
    ShadedScan<Form, N, A, decltype(ignore)> scan(triangle.triangle, setUp, m_settings.fillRule,
                                                  frame, ignore);
    // Strips that meet the triangle in more than a line.
    const std::int64_t first
        = std::max<std::int64_t>(floorPixel(corners[0].x + halfPixel), frame.firstColumn);
    const std::int64_t end = std::min(ceilPixel(corners[2].x - halfPixel) + 1, frame.endColumn());
    bool isSeen = false;
    for (std::int64_t x = first; x < end; ++x) {
        const CoveredStrip strip = coveredStrip(corners, x);
        Column column = scan.columnAt(x);
        column.firstRow = strip.met.first;
        column.endRow = strip.met.end;
        column.firstDrawn = std::max<std::int64_t>(strip.met.first, frame.firstRow);
        column.endDrawn = std::min(strip.met.end, frame.endRow());
        if (column.firstDrawn >= column.endDrawn)
            continue;
        isSeen = true;
        m_observer.spanEntered(column);
        const auto drawPart = [&](std::int64_t y) {
            const PixelArea area(triangle.triangle, x, y);
            if (area.isEmpty())
                return;
            ShadedSurface<N> part = whole;
            part.area = &area;
            shadeColumn<Form>(setUp, column, RowRun{y, y + 1}, covering, part, frame, m_observer);
        };
        const RowRun inside = {std::clamp(strip.whole.first, column.firstDrawn, column.endDrawn),
                               std::clamp(strip.whole.end, column.firstDrawn, column.endDrawn)};
        for (std::int64_t y = column.firstDrawn; y < inside.first; ++y)
            drawPart(y);
        shadeRun(setUp, column, inside, whole, frame);
        for (std::int64_t y = inside.end; y < column.endDrawn; ++y)
            drawPart(y);
    }
    if (!isSeen)
        m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
}

} // namespace pixelplumb
