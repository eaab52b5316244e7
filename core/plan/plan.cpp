// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/bordercrossing.h"
#include "core/plan/requirements.h"
#include "core/shade/linecolours.h"
#include "core/shade/triangleneeds.h"
#include "core/space/vertexlight.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Texture and light cannot be forced on without texels, normals or lights.
EffectSet withForcing(EffectSet effects, const TriangleAttributes *attributes,
                      const Appearance &appearance)
{
    const EffectForcing &forced = appearance.forced;
    effects.smooth = isForced(effects.smooth, forced[Effect::SmoothColour]);
    effects.perspective = isForced(effects.perspective, forced[Effect::Perspective]);
    effects.blending = isForced(effects.blending, forced[Effect::Blending]);
    effects.texture = effects.texture && forced[Effect::Texture] != Forcing::Off;
    const bool canBeLit = attributes && appearance.shading == Shading::Phong
        && hasNormals(*attributes) && !appearance.lights.empty();
    effects.light = canBeLit && isForced(effects.light, forced[Effect::Light]);
    return effects;
}

DepthTest depthTestOf(DepthFormat format)
{
    return format == DepthFormat::Exact ? DepthTest::Number : DepthTest::Levels;
}

/// Whether depth runs for a triangle.
bool runsDepth(const Appearance &appearance, const DepthAnswer &depth, std::size_t triangle)
{
    const bool isInQuestion = !depth.inQuestion.empty() && depth.inQuestion[triangle];
    const bool isNeeded
        = appearance.depth == DepthUse::On || (appearance.depth == DepthUse::Auto && isInQuestion);
    return isForced(isNeeded, appearance.forced[Effect::Depth]);
}

/// Collects triangles in order into batches with one set of effects. Triangles that reach no pixel
/// join a neighbouring batch.
class BatchList {
public:
    void add(const EffectSet &effects)
    {
        if (m_hasEffects && m_batches.back().effects != effects)
            m_batches.push_back({m_batches.back().first + m_batches.back().count, 0, effects, 0});
        append();
        m_batches.back().effects = effects;
        m_hasEffects = true;
    }
    void addUnseen()
    {
        append();
        ++m_batches.back().unseen;
    }
    std::vector<EffectBatch> batches() && { return std::move(m_batches); }

private:
    void append()
    {
        if (m_batches.empty())
            m_batches.emplace_back();
        ++m_batches.back().count;
    }

    std::vector<EffectBatch> m_batches;
    bool m_hasEffects = false; ///< some triangle of the last batch reaches the frame
};

std::vector<EffectBatch> batchesOf(const Primitives &primitives, const SampledFrame &where,
                                   const DepthAnswer &depth)
{
    const Appearance &appearance = primitives.appearance;
    const DepthTest test = depthTestOf(appearance.depthFormat);
    BatchList list;
    auto next = primitives.attributes.begin();
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        const bool hasAttributes = next != primitives.attributes.end() && next->triangle == i;
        const TriangleAttributes *attributes = hasAttributes ? &*next++ : nullptr;
        const Triangle &triangle = primitives.triangles[i];
        if (reachOf(triangle, where).isEmpty()) {
            list.addUnseen();
            continue;
        }
        EffectSet effects = withForcing(needsOf(triangle, attributes, appearance).effects,
                                        attributes, appearance);
        effects.depth = runsDepth(appearance, depth, i) ? test : DepthTest::None;
        list.add(effects);
    }
    return std::move(list).batches();
}

/// Depth that is forced on compares rounded depths, and so may refuse samples of a triangle that is
/// not behind; a triangle of one depth has that depth unrounded.
bool mayRoundInOrder(const Appearance &appearance, const ScanSettings &settings,
                     const DepthAnswer &depth)
{
    const bool isRounded
        = settings.arithmetic == Arithmetic::Float32 || settings.arithmetic == Arithmetic::Float64;
    return isRounded && appearance.forced[Effect::Depth] == Forcing::On
        && appearance.depth == DepthUse::Auto && depth.ground != DepthAnswer::Ground::FewTriangles
        && depth.ground != DepthAnswer::Ground::SameDepth;
}

/// Whether lines in the frame change from colour to colour.
bool runsOnLines(const Primitives &primitives, const SampledFrame &where)
{
    const Forcing forced = primitives.appearance.forced[Effect::SmoothColour];
    return std::ranges::any_of(primitives.shapes, [&](const Shape &shape) {
        return shape.kind == PrimitiveKind::Line && isForced(isSmoothLine(shape), forced)
            && borderCrossingOf(shape, where) != BorderCrossing::Outside;
    });
}

} // namespace

bool EffectPlan::runsOnTriangles(Effect effect) const
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
    const Appearance &appearance = primitives.appearance;
    EffectPlan plan;
    plan.antialiasing = triangleAntialiasing(primitives, settings, frame);
    plan.strokeAntialiasing = strokeAntialiasing(primitives, frame);
    const SampledFrame where = sampledFrame(frame, settings, plan.antialiasing);
    const DepthAnswer depth = depthQuestion(primitives, settings, frame, plan.antialiasing);
    plan.verdicts = requirementsWith(primitives, where, depth);
    if (mayRoundInOrder(appearance, settings, depth))
        plan.verdicts[Effect::Depth].reason
            += QStringLiteral("; forced on, it compares depths that are rounded: where two are "
                              "equal or nearly so, the later triangle may lose the pixel");
    plan.batches = batchesOf(primitives, where, depth);
    plan.smoothLines
        = runsOnLines(primitives, {frame, settings.fillRule, antialiasingOf(appearance)});
    plan.vertexLight
        = lightsVertices(appearance)
        && std::ranges::any_of(primitives.attributes, [&](const TriangleAttributes &attributes) {
               return hasNormals(attributes)
                   && !reachOf(primitives.triangles[attributes.triangle], where).isEmpty();
           });
    return plan;
}

} // namespace pixelplumb
