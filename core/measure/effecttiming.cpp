// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/effecttiming.h"

#include "core/frame/writtenframe.h"
#include "core/measure/stopwatch.h"
#include "core/runs/tracedscene.h"
#include "core/shade/shadeddrawing.h"

#include <cmath>

namespace pixelplumb {

namespace {

DifferenceMap differingPixels(const FrameBuffer &a, const FrameBuffer &b)
{
    DifferenceMap differing(a.spec());
    const FrameView view = a.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            if (*view.at(x, y) != *b.view().at(x, y))
                differing.set(x, y, Difference::Colour);
        }
    }
    return differing;
}

/// The work that an effect does at samples.
std::vector<EffectWork> workOf(Effect effect)
{
    switch (effect) {
    case Effect::Depth:
        return {EffectWork::DepthRead, EffectWork::DepthWrite};
    case Effect::Perspective:
        return {EffectWork::Division};
    case Effect::Texture:
        return {EffectWork::TexelFetch};
    case Effect::Light:
        return {EffectWork::Normal};
    case Effect::Blending:
        return {EffectWork::Blend};
    case Effect::Antialiasing:
        return {EffectWork::Sample};
    case Effect::SmoothColour:
    case Effect::Clipping:
        break;
    }
    return {};
}

Scene forced(Scene scene, const EffectForcing &forcing)
{
    scene.appearance.forced = forcing;
    return scene;
}

/// Draws the scene with one effect on and off.
class EffectRace {
public:
    EffectRace(const Scene &scene, const TimingOptions &options)
        : m_options(options)
        , m_scene(scene)
        , m_on(scene)
        , m_off(m_on)
        , m_onFrame(scene.frame)
        , m_offFrame(scene.frame)
    {
    }

    std::optional<EffectTiming> run()
    {
        EffectTiming timing;
        timing.rounds = m_options.rounds;
        timing.pixels = writtenPixels();
        for (const Effect effect : allEffects) {
            force(effect);
            if (!isTold() || !differs())
                continue;
            timing.costs[effect] = race();
            timing.costs[effect]->operations = countOperations(effect);
        }
        if (m_isEnded)
            return std::nullopt;
        return timing;
    }

private:
    void force(Effect effect)
    {
        for (auto &[run, forcing] :
             {std::pair(&m_on, Forcing::On), std::pair(&m_off, Forcing::Off)}) {
            EffectForcing forcings;
            forcings[effect] = forcing;
            const Scene scene = forced(m_scene, forcings);
            // Light may be part of the colours from set-up on.
            const bool isLitAnew = effect == Effect::Light
                || run->primitives.appearance.forced[Effect::Light] != Forcing();
            Primitives primitives
                = isLitAnew ? primitivesOnSamples(scene) : std::move(run->primitives);
            primitives.appearance.forced = forcings;
            *run = SceneRun(scene, std::move(primitives));
            run->kernels = Kernels::Plain;
        }
    }

    bool isTold()
    {
        const int all = m_options.rounds * int(allEffects.size());
        m_isEnded = m_isEnded
            || !goesOn(m_options.progress, {JobPhase::Measuring, std::min(m_done, all), all});
        return !m_isEnded;
    }

    /// Whether the method can draw both, and whether they differ at all.
    bool differs()
    {
        const Method &method = *m_on.method;
        const bool isSame = m_on.plan->runsAs(*m_off.plan);
        const bool canDraw
            = method.objection(*m_on.plan, m_on.settings).isEmpty()
            && method.objection(*m_off.plan, m_off.settings).isEmpty()
            && std::ranges::all_of(m_on.primitives.shapes, [&](const Shape &shape) {
                   return method.objection(shape, m_on.primitives.appearance, m_on.settings)
                       .isEmpty();
               });
        if (isSame || !canDraw)
            m_done += m_options.rounds;
        return !isSame && canDraw;
    }

    std::int64_t writtenPixels() const
    {
        const WrittenFrame written(m_onFrame.spec());
        m_on.draw(written.view());
        std::int64_t count = 0;
        const FrameView view = written.view();
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
                count += written.isWritten(x, y) ? 1 : 0;
        }
        return count;
    }

    /// Coverage and the work at covered samples are the same in every triangle method.
    std::optional<std::int64_t> countOperations(Effect effect) const
    {
        const std::vector<EffectWork> work = workOf(effect);
        if (work.empty() || m_on.primitives.triangles.empty())
            return std::nullopt;
        const ScanSettings &settings = m_on.settings;
        const ScanSettings exact{Arithmetic::Exact, settings.fillRule, settings.rounding};
        const FrameView frame = m_onFrame.view();
        const EffectTally tally = drawShaded(ShadedMethod::ColumnScan, m_on.primitives, exact,
                                             frame, planFor(m_on.primitives, exact, frame))
                                      .value();
        std::int64_t operations = 0;
        for (const EffectWork each : work)
            operations += tally[each];
        return operations;
    }

    EffectCost race()
    {
        EffectCost cost;
        m_onFrame.clear();
        m_offFrame.clear();
        const double longest = std::max(timeOf(m_on, m_onFrame, 1), timeOf(m_off, m_offFrame, 1));
        cost.changed = differingPixels(m_onFrame, m_offFrame).total();
        const int times
            = std::max(1, int(std::ceil(m_options.sampleNanoseconds / std::max(longest, 1.0))));
        std::vector<double> on, off, ratio;
        for (int round = 0; round < m_options.rounds && isTold(); ++round, ++m_done) {
            // Rounds alternate in which one begins, so that neither always follows its neighbour.
            if (round % 2 == 0) {
                on.push_back(timeOf(m_on, m_onFrame, times));
                off.push_back(timeOf(m_off, m_offFrame, times));
            } else {
                off.push_back(timeOf(m_off, m_offFrame, times));
                on.push_back(timeOf(m_on, m_onFrame, times));
            }
            ratio.push_back(on.back() / off.back());
        }
        if (ratio.empty())
            return cost;
        cost.on = spreadOf(on);
        cost.off = spreadOf(off);
        cost.ratio = spreadOf(ratio);
        return cost;
    }

    /// ns per draw.
    static double timeOf(const Run &run, const FrameBuffer &frame, int times)
    {
        const Stopwatch watch;
        for (int i = 0; i < times; ++i)
            run.draw(frame.view());
        return std::max(watch.elapsed().thread, 1.0) / times;
    }

    const TimingOptions &m_options;
    const Scene &m_scene;
    SceneRun m_on;
    SceneRun m_off;
    FrameBuffer m_onFrame;
    FrameBuffer m_offFrame;
    int m_done = 0;
    bool m_isEnded = false;
};

} // namespace

std::optional<EffectTiming> timeEffects(const Scene &scene, const TimingOptions &options)
{
    const Scene asCalledFor = forced(scene, {});
    return EffectRace(asCalledFor, options).run();
}

DifferenceMap changesByForcing(const SceneRun &run)
{
    const FrameBuffer drawn(run.scene.frame);
    const FrameBuffer asCalledFor(run.scene.frame);
    run.draw(drawn.view());
    drawScene(forced(run.scene, {}), asCalledFor);
    return differingPixels(drawn, asCalledFor);
}

} // namespace pixelplumb
