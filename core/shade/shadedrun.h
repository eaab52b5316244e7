// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scanobserver.h"
#include "core/shade/coveredstrip.h"
#include "core/shade/edgepixels.h"
#include "core/shade/shadedscan.h"
#include "core/shade/stagelist.h"
#include "core/shade/triangleneeds.h"
#include "core/space/materialcolour.h"

#include <vector>

namespace pixelplumb {

/// The depth buffer and lights shared by the triangles of one picture: memory is allocated only for
/// what the plan runs.
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

/// The pixels drawn in one pass of a picture with several samples, and the sample from which they
/// see the triangles.
struct SampledPixels {
    const EdgePixels &edges;
    bool ofEdges = false; ///< pixels that meet an edge, or the others
    LatticePoint sample; ///< offset from the pixel's own sample
};

/// Draws shaded triangles one by one. The stages are the same whether or not the observer reads
/// numbers; one that does gets the numbers that the stages leave, sample by sample.
template <class N, class A, class Observer>
class ShadedRun {
public:
    using Column = BoundedColumn<N, A>;

    ShadedRun(InterpolationForm form, const Primitives &primitives, const ScanSettings &settings,
              Observer observer)
        : m_form(form)
        , m_primitives(primitives)
        , m_settings(settings)
        , m_observer(observer)
        , m_read(readsNumbers<Observer> ? StagedSamples<N>::capacity : 0)
    {
        m_samples.read = m_read.empty() ? nullptr : m_read.data();
    }

    /// Draws one sample per pixel, in all pixels or in some.
    void draw(std::size_t index, const EffectSet &effects, FrameView frame,
              ShadedSurroundings<N> &surroundings, const SampledPixels *pixels = nullptr);

    /// Draws with α times the exact area of the triangle in each pixel's square. A segment, which
    /// has none, is drawn as without antialiasing.
    void drawAreas(std::size_t index, const EffectSet &effects, FrameView frame,
                   ShadedSurroundings<N> &surroundings);

    /// How often the stages did costly work.
    const EffectCounts &work() const { return m_samples.done; }

private:
    ShadedTriangle triangleAt(std::size_t index, const EffectSet &effects) const
    {
        const Triangle &triangle = m_primitives.triangles[index];
        const TriangleAttributes *attributes = m_primitives.attributesOf(index);
        const bool corrects
            = effects.perspective && hasHorizon(triangle, attributes, m_primitives.appearance);
        return {triangle, attributes, corrects ? DivisionBy::W : DivisionBy::One};
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
                packed(oneColourOf(triangle.triangle)),
                nullptr};
    }

    /// Announces the triangle; false if it is not drawn.
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

    StageList<N> stagesOf(const EffectSet &effects, const ShadedSurface<N> &surface,
                          bool coversAreas) const
    {
        return StageList<N>(
            {m_form, effects, surface.material->filter, coversAreas, readsNumbers<Observer>});
    }

    void enter(const ShadedSetUp<N> &setUp, const Column &column)
    {
        m_observer.spanEntered(column);
        m_samples.setUp = &setUp;
        m_samples.column = &column;
    }

    /// Runs the stages on rows of the entered column.
    void shade(const StageList<N> &stages, const ShadedSurface<N> &surface, const RowRun &rows,
               FrameView frame)
    {
        m_samples.surface = &surface;
        m_samples.start = rows.first;
        for (std::int64_t first = rows.first; first < rows.end;) {
            const std::int64_t count
                = std::min<std::int64_t>(rows.end - first, StagedSamples<N>::capacity);
            m_samples.enter(first, std::size_t(count), frame);
            stages(m_samples);
            if constexpr (readsNumbers<Observer>)
                announce();
            first += count;
        }
    }

    /// Announces each shaded sample, including refused ones, then writes its pixel.
    void announce()
    {
        std::size_t inPlay = 0;
        for (std::size_t row = 0; row < m_samples.size; ++row) {
            const std::int64_t y = m_samples.firstRow + std::int64_t(row);
            QRgb &pixel = m_samples.firstPixel[std::ptrdiff_t(row) * m_samples.stride];
            ShadedSample<N> &sample = m_read[row];
            if (inPlay == m_samples.count || m_samples.rowOf(inPlay) != row) {
                m_observer.sampleRejected(m_samples.column->x, y, pixel, sample);
                continue;
            }
            sample.before = pixel;
            sample.after = m_samples.colour[inPlay++];
            m_observer.pixelWritten(m_samples.column->x, y, sample.before, sample.after, sample);
            pixel = sample.after;
        }
    }

    InterpolationForm m_form;
    const Primitives &m_primitives;
    ScanSettings m_settings;
    Observer m_observer;
    std::vector<ShadedSample<N>> m_read; ///< one per row of a run, where the observer reads numbers
    StagedSamples<N> m_samples;
};

template <class N, class A, class Observer>
void ShadedRun<N, A, Observer>::draw(std::size_t index, const EffectSet &effects, FrameView frame,
                                     ShadedSurroundings<N> &surroundings,
                                     const SampledPixels *pixels)
{
    const ShadedTriangle given = triangleAt(index, effects);
    // A segment covers whole pixels: all their samples are taken as at the pixel's own.
    const Triangle seen = pixels && doubledArea(given.triangle) != 0
        ? seenFrom(given.triangle, pixels->sample)
        : given.triangle;
    const ShadedTriangle triangle{seen, given.attributes, given.division};
    const auto setUp = shadedSetUpOf<N>(m_form, triangle, effects);
    if (!begins(triangle, setUp))
        return;
    const ShadedSurface<N> surface = surfaceOf(triangle, surroundings);
    const StageList<N> stages = stagesOf(effects, surface, false);
    const ShadedScan<N, A> scan(seen, setUp, m_settings.fillRule, frame);
    const bool isSeen = scan.run([&](const Column &column) {
        enter(setUp, column);
        const RowRun drawn{column.firstDrawn, column.endDrawn};
        if (!pixels)
            shade(stages, surface, drawn, frame);
        else if (drawn.first < drawn.end)
            pixels->edges.forEachRun(column.x, drawn, pixels->ofEdges, [&](const RowRun &rows) {
                shade(stages, surface, rows, frame);
            });
    });
    if (!isSeen)
        m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
}

template <class N, class A, class Observer>
void ShadedRun<N, A, Observer>::drawAreas(std::size_t index, const EffectSet &effects,
                                          FrameView frame, ShadedSurroundings<N> &surroundings)
{
    const ShadedTriangle given = triangleAt(index, effects);
    if (doubledArea(given.triangle) == 0)
        return draw(index, effects, frame, surroundings);
    // The area acts as an alpha: it is the only one where blending is forced off.
    TriangleAttributes opaque;
    const bool isOpaque = given.attributes && !effects.blending;
    if (isOpaque) {
        opaque = *given.attributes;
        for (VertexAttributes &vertex : opaque.vertices)
            vertex.alpha = VertexAttributes().alpha;
    }
    const ShadedTriangle triangle{given.triangle, isOpaque ? &opaque : given.attributes,
                                  given.division};
    EffectSet covering = effects;
    covering.blending = true;
    const auto setUp = shadedSetUpOf<N>(m_form, triangle, covering);
    if (!begins(triangle, setUp))
        return;
    const ShadedSurface<N> whole = surfaceOf(triangle, surroundings);
    const StageList<N> ofWhole = stagesOf(effects, whole, false);
    const StageList<N> ofParts = stagesOf(covering, whole, true);
    std::array<LatticePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = setUp.vertices[std::size_t(setUp.order[i])].position;
    const ShadedScan<N, A> scan(triangle.triangle, setUp, m_settings.fillRule, frame);
    // The strips that meet the triangle in more than a line.
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
        enter(setUp, column);
        const auto drawPart = [&](std::int64_t y) {
            const PixelArea area(triangle.triangle, x, y);
            if (area.isEmpty())
                return;
            ShadedSurface<N> part = whole;
            part.area = &area;
            shade(ofParts, part, {y, y + 1}, frame);
        };
        const RowRun inside = {std::clamp(strip.whole.first, column.firstDrawn, column.endDrawn),
                               std::clamp(strip.whole.end, column.firstDrawn, column.endDrawn)};
        for (std::int64_t y = column.firstDrawn; y < inside.first; ++y)
            drawPart(y);
        shade(ofWhole, whole, inside, frame);
        for (std::int64_t y = inside.end; y < column.endDrawn; ++y)
            drawPart(y);
    }
    if (!isSeen)
        m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
}

} // namespace pixelplumb
