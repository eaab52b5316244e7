// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/framereach.h"
#include "core/effects/requirements.h"
#include "core/effects/triangleneeds.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isForced(bool isNeeded, Forcing forcing)
{
    return forcing == Forcing::AsCalledFor ? isNeeded : forcing == Forcing::On;
}

/// Texture and light have nothing to work with where there are no texels and no normals; a light
/// that is forced on shines from where lights are, and is the ambient one where there are none.
EffectSet withForcing(EffectSet effects, const TriangleAttributes *attributes,
                      const Appearance &appearance)
{
    const EffectForcing &forced = appearance.forced;
    effects.smooth = isForced(effects.smooth, forced[Effect::SmoothColour]);
    effects.perspective = isForced(effects.perspective, forced[Effect::Perspective]);
    effects.blending = isForced(effects.blending, forced[Effect::Blending]);
    effects.texture = effects.texture && forced[Effect::Texture] != Forcing::Off;
    const bool canBeLit
        = attributes && appearance.shading == Shading::Phong && hasNormals(*attributes);
    effects.light = canBeLit && isForced(effects.light, forced[Effect::Light]);
    return effects;
}

DepthTest depthTestOf(DepthFormat format)
{
    return format == DepthFormat::Exact ? DepthTest::Number : DepthTest::Levels;
}

/// Whether depth runs for a triangle, before triangles are gathered.
bool runsDepth(const Appearance &appearance, const DepthAnswer &depth, std::size_t triangle)
{
    switch (appearance.forced[Effect::Depth]) {
    case Forcing::AsCalledFor:
        break;
    case Forcing::On:
        return true;
    case Forcing::Off:
        return false;
    }
    switch (appearance.depth) {
    case DepthUse::Auto:
        return !depth.inQuestion.empty() && depth.inQuestion[triangle];
    case DepthUse::Off:
        return false;
    case DepthUse::On:
        return true;
    }
    return false;
}

/// Gathers triangles in order. What reaches no pixel joins whatever stands beside it. Depth does
/// not part a run: where one triangle needs it, it runs for all of the run, because those that are
/// not in question pass its test wherever they would have been drawn.
class BatchList {
public:
    void add(const EffectSet &effects, DepthTest depth)
    {
        if (m_batches.empty() || !m_hasEffects || m_effects == effects) {
            extend(effects, depth);
            return;
        }
        m_batches.push_back({m_batches.back().first + m_batches.back().count, 0, effects});
        extend(effects, depth);
    }
    void addUnseen()
    {
        if (m_batches.empty())
            m_batches.emplace_back();
        ++m_batches.back().count;
    }
    std::vector<EffectBatch> batches() && { return std::move(m_batches); }

private:
    void extend(const EffectSet &effects, DepthTest depth)
    {
        addUnseen();
        m_effects = effects;
        m_hasEffects = true;
        EffectSet &running = m_batches.back().effects;
        const DepthTest kept = running.depth;
        running = effects;
        running.depth = depth == DepthTest::None ? kept : depth;
    }

    std::vector<EffectBatch> m_batches;
    EffectSet m_effects; ///< of the last batch, without depth
    bool m_hasEffects = false; ///< a triangle of it reaches the frame
};

std::vector<EffectBatch> batchesOf(const Primitives &primitives, const FrameView &frame,
                                   const DepthAnswer &depth, Antialiasing antialiasing)
{
    const Appearance &appearance = primitives.appearance;
    const DepthTest test = depthTestOf(appearance.depthFormat);
    BatchList list;
    auto next = primitives.attributes.begin();
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        const bool hasAttributes = next != primitives.attributes.end() && next->triangle == i;
        const TriangleAttributes *attributes = hasAttributes ? &*next++ : nullptr;
        const Triangle &triangle = primitives.triangles[i];
        if (reachOf(triangle, frame, antialiasing).isEmpty()) {
            list.addUnseen();
            continue;
        }
        const EffectSet needed = needsOf(triangle, attributes, appearance).effects;
        list.add(withForcing(needed, attributes, appearance),
                 runsDepth(appearance, depth, i) ? test : DepthTest::None);
    }
    return std::move(list).batches();
}

} // namespace

Antialiasing antialiasingOf(const Appearance &appearance)
{
    switch (appearance.forced[Effect::Antialiasing]) {
    case Forcing::AsCalledFor:
        break;
    case Forcing::On:
        return appearance.antialiasing == Antialiasing::None ? Antialiasing::Samples4
                                                             : appearance.antialiasing;
    case Forcing::Off:
        return Antialiasing::None;
    }
    return appearance.antialiasing;
}

bool EffectPlan::runs(Effect effect) const
{
    if (effect == Effect::Antialiasing)
        return antialiasing != Antialiasing::None;
    if (effect == Effect::Clipping)
        return verdicts[effect].verdict != Verdict::NotCalledFor;
    return std::ranges::any_of(
        batches, [effect](const EffectBatch &batch) { return contains(batch.effects, effect); });
}

EffectPlan planFor(const Primitives &primitives, const ScanSettings &settings,
                   const FrameView &frame)
{
    EffectPlan plan;
    plan.antialiasing = antialiasingOf(primitives.appearance);
    const DepthAnswer depth = depthQuestion(primitives, settings, frame, plan.antialiasing);
    plan.verdicts = requirementsWith(primitives, settings, frame, depth);
    plan.batches = batchesOf(primitives, frame, depth, plan.antialiasing);
    return plan;
}

} // namespace pixelplumb
