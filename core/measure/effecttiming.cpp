// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/effecttiming.h"

#include "core/effects/shadeddrawing.h"
#include "core/frame/writtenframe.h"
#include "core/measure/stopwatch.h"
#include "core/methods/method.h"

#include <cmath>

namespace pixelplumb {

namespace {

const Method &methodOfScene(const Scene &scene)
{
    return *methodNamed(QString::fromStdString(scene.method));
}

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

/// The scene's primitives with this forcing.
Primitives primitivesForced(const Scene &scene, const EffectForcing &forced)
{
    Scene drawn = scene;
    drawn.appearance.forced = forced;
    return primitivesOnSamples(drawn);
}

/// Draws the scene with one effect on and off.
class EffectRace {
public:
    EffectRace(const Scene &scene, const TimingOptions &options)
        : m_options(options)
        , m_method(methodOfScene(scene))
        , m_scene(scene)
        , m_settings(scene.settings)
        , m_on(primitivesOnSamples(scene))
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
        for (auto &[primitives, forcing] :
             {std::pair(&m_on, Forcing::On), std::pair(&m_off, Forcing::Off)}) {
            EffectForcing forced;
            forced[effect] = forcing;
            // Light may be part of the colours from set-up on.
            if (effect == Effect::Light
                || primitives->appearance.forced[Effect::Light] != Forcing())
                *primitives = primitivesForced(m_scene, forced);
            primitives->appearance.forced = forced;
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
        const EffectPlan on = planFor(m_on, m_settings, m_onFrame.view());
        const EffectPlan off = planFor(m_off, m_settings, m_offFrame.view());
        const bool isSame = on.runsAs(off);
        const bool canDraw
            = m_method.objection(on, m_settings).isEmpty()
            && m_method.objection(off, m_settings).isEmpty()
            && std::ranges::all_of(m_on.shapes, [this](const Shape &shape) {
                   return m_method.objection(shape, m_on.appearance, m_settings).isEmpty();
               });
        if (isSame || !canDraw)
            m_done += m_options.rounds;
        return !isSame && canDraw;
    }

    std::int64_t writtenPixels() const
    {
        const WrittenFrame written(m_onFrame.spec());
        m_method.draw(m_on, m_settings, written.view());
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
        if (work.empty() || m_on.triangles.empty())
            return std::nullopt;
        const ScanSettings exact{Arithmetic::Exact, m_settings.fillRule, m_settings.rounding};
        const EffectTally tally
            = drawShaded(ShadedMethod::ColumnScan, m_on, exact, m_onFrame.view(),
                         planFor(m_on, exact, m_onFrame.view()))
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
    double timeOf(const Primitives &primitives, const FrameBuffer &frame, int times) const
    {
        const Stopwatch watch;
        for (int i = 0; i < times; ++i)
            m_method.draw(primitives, m_settings, frame.view());
        return std::max(watch.elapsed().thread, 1.0) / times;
    }

    const TimingOptions &m_options;
    const Method &m_method;
    const Scene &m_scene;
    ScanSettings m_settings;
    Primitives m_on;
    Primitives m_off;
    FrameBuffer m_onFrame;
    FrameBuffer m_offFrame;
    int m_done = 0;
    bool m_isEnded = false;
};

} // namespace

std::optional<EffectTiming> timeEffects(const Scene &scene, const TimingOptions &options)
{
    Scene asCalledFor = scene;
    asCalledFor.appearance.forced = {};
    return EffectRace(asCalledFor, options).run();
}

DifferenceMap changesByForcing(const Scene &scene)
{
    const FrameBuffer forced(scene.frame);
    const FrameBuffer asCalledFor(scene.frame);
    const Method &method = methodOfScene(scene);
    method.drawFastest(primitivesOnSamples(scene), scene.settings, forced.view());
    method.drawFastest(primitivesForced(scene, {}), scene.settings, asCalledFor.view());
    return differingPixels(forced, asCalledFor);
}

} // namespace pixelplumb
