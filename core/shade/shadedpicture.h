// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/number/jobprogress.h"
#include "core/shade/scratchframe.h"
#include "core/shade/shadedchoice.h"

#include <vector>

namespace pixelplumb {

/// Draws all triangles of a plan, without an observer.
template <class N, class A>
class ShadedPicture {
public:
    ShadedPicture(InterpolationForm form, const Primitives &primitives,
                  const ScanSettings &settings, FrameView frame, const EffectPlan &plan,
                  const ProgressListener &listener)
        : m_primitives(primitives)
        , m_plan(plan)
        , m_frame(frame)
        , m_surroundings(plan, primitives.appearance, frame)
        , m_run(form, primitives, settings, NullObserver{})
        , m_listener(listener)
    {
    }

    /// False if the listener ended it. Before each triangle it gets the number drawn, counting once
    /// more for each separately drawn sample.
    bool draw()
    {
        switch (m_plan.antialiasing) {
        case Antialiasing::None:
            return forEachTriangle([&](std::size_t index, const EffectSet &effects) {
                m_run.draw(index, effects, m_frame, m_surroundings);
            });
        case Antialiasing::Area:
            return forEachTriangle([&](std::size_t index, const EffectSet &effects) {
                m_run.drawAreas(index, effects, m_frame, m_surroundings);
            });
        case Antialiasing::Samples4:
        case Antialiasing::Samples16:
            break;
        }
        return drawSamples();
    }

    EffectTally tally() const { return {m_run.work(), m_surroundings.depths.bytes()}; }

private:
    template <class Draw>
    bool forEachTriangle(const Draw &draw)
    {
        const std::size_t count = m_primitives.triangles.size();
        const std::size_t times = 1 + samplePattern(m_plan.antialiasing).size();
        TriangleEffects effects(m_plan);
        for (std::size_t index = 0; index < count; ++index) {
            if (!goesOn(m_listener, {JobPhase::Drawing, m_done++, std::int64_t(times * count)}))
                return false;
            draw(index, effects.at(index));
        }
        return true;
    }

    /// Draws the pixels without an edge once, those with one once per sample.
    bool drawSamples()
    {
        const EdgePixels edges(m_primitives.triangles, m_frame);
        const SampledPixels others{edges, false, {0, 0}};
        ScratchFrame before(m_frame);
        before.copyFrom(m_frame);
        const bool isComplete = forEachTriangle([&](std::size_t index, const EffectSet &effects) {
            m_run.draw(index, effects, m_frame, m_surroundings, &others);
        });
        if (!isComplete || edges.count() == 0)
            return isComplete;
        std::vector<SampleMean> means(std::size_t(m_frame.width) * std::size_t(m_frame.height));
        ScratchFrame scratch(m_frame);
        for (const LatticePoint &sample : samplePattern(m_plan.antialiasing)) {
            scratch.copyFrom(before.view());
            ShadedSurroundings<N> own(m_plan, m_primitives.appearance, m_frame);
            const SampledPixels pixels{edges, true, sample};
            const auto drawSample = [&](std::size_t index, const EffectSet &effects) {
                m_run.draw(index, effects, scratch.view(), own, &pixels);
            };
            if (!forEachTriangle(drawSample))
                return false;
            forEachEdgePixel(edges, [&](std::int64_t x, std::int64_t y) {
                means[placeOf(x, y)].add(*scratch.view().at(x, y));
            });
        }
        forEachEdgePixel(edges, [&](std::int64_t x, std::int64_t y) {
            *m_frame.at(x, y) = means[placeOf(x, y)].pixel();
        });
        return true;
    }

    std::size_t placeOf(std::int64_t x, std::int64_t y) const
    {
        return std::size_t(y - m_frame.firstRow) * std::size_t(m_frame.width)
            + std::size_t(x - m_frame.firstColumn);
    }

    template <class Function>
    void forEachEdgePixel(const EdgePixels &edges, const Function &function) const
    {
        for (std::int64_t x = m_frame.firstColumn; x < m_frame.endColumn(); ++x) {
            edges.forEachRun(x, {m_frame.firstRow, m_frame.endRow()}, true, [&](const RowRun &run) {
                for (std::int64_t y = run.first; y < run.end; ++y)
                    function(x, y);
            });
        }
    }

    const Primitives &m_primitives;
    const EffectPlan &m_plan;
    FrameView m_frame;
    ShadedSurroundings<N> m_surroundings;
    ShadedRun<N, A, NullObserver> m_run;
    const ProgressListener &m_listener;
    std::int64_t m_done = 0; ///< triangles
};

} // namespace pixelplumb
