// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/requirements.h"

#include "core/plan/bordercrossing.h"
#include "core/plan/effectreason.h"
#include "core/plan/framereach.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

std::int64_t pixelsOf(const FrameView &frame) { return std::int64_t(frame.width) * frame.height; }

/// An upper bound for the pixels that the triangles in question may touch.
std::int64_t pixelsInQuestion(const Primitives &primitives, const SampledFrame &where,
                              const DepthAnswer &depth)
{
    std::int64_t pixels = 0;
    for (std::size_t i = 0; i < depth.inQuestion.size(); ++i) {
        if (!depth.inQuestion[i])
            continue;
        const Triangle &triangle = primitives.triangles[i];
        pixels += mostPixelsOf(triangle, reachOf(triangle, where), where.antialiasingOf(triangle));
    }
    return pixels;
}

EffectVerdict depthVerdict(const Primitives &primitives, const NeedsTally &tally,
                           const SampledFrame &where, const DepthAnswer &depth)
{
    EffectVerdict verdict;
    if (tally.drawnTriangles == 0 && primitives.appearance.depth != DepthUse::Off) {
        verdict.reason = effectReason(Effect::Depth, tally, primitives, where);
        return verdict;
    }
    switch (primitives.appearance.depth) {
    case DepthUse::Off:
        verdict.reason = "the scene says so: what is drawn later covers what was drawn before";
        return verdict;
    case DepthUse::On:
        verdict.reason = "the scene says so, for all triangles";
        verdict.verdict = Verdict::CalledFor;
        verdict.primitives = tally.drawnTriangles;
        verdict.pixels = pixelsOf(where.frame);
        return verdict;
    case DepthUse::Auto:
        break;
    }
    return {depth.verdict, depthReason(depth, where), depth.countInQuestion(),
            pixelsInQuestion(primitives, where, depth)};
}

Verdict verdictOf(Effect effect, const NeedsTally &tally)
{
    if (tally.of[effect].primitives == 0)
        return Verdict::NotCalledFor;
    const bool isInDoubt
        = effect == Effect::Clipping && tally.crossing == 0 && tally.cutAtNear == 0;
    return isInDoubt ? Verdict::NotRuledOut : Verdict::CalledFor;
}

/// The requested antialiasing, if something calls for it or, when forced, if something that can
/// have it is drawn; else none. Primitives are examined only where more than one sample is
/// requested.
template <class IsCalledFor, class IsDrawn>
Antialiasing runningOf(const Appearance &appearance, const SampledFrame &asked,
                       const IsCalledFor &isCalledFor, const IsDrawn &isDrawn)
{
    const bool isForced = appearance.forced[Effect::Antialiasing] != Forcing::AsCalledFor;
    const bool runs
        = asked.antialiasing != Antialiasing::None && (isCalledFor() || (isForced && isDrawn()));
    return runs ? asked.antialiasing : Antialiasing::None;
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

Antialiasing triangleAntialiasing(const Primitives &primitives, const ScanSettings &settings,
                                  const FrameView &frame)
{
    const Appearance &appearance = primitives.appearance;
    const SampledFrame asked = sampledFrame(frame, settings, antialiasingOf(appearance));
    const auto isSoOfAny = [&](const auto &is) {
        return std::ranges::any_of(primitives.triangles,
                                   [&](const Triangle &triangle) { return is(triangle, asked); });
    };
    const auto isAnyDrawn = [&] { return isSoOfAny(isDrawnEitherWay); };
    // The edges of a triangle that lies between all samples divide the pixels of others.
    const auto isCalledFor = [&] {
        return isSoOfAny([](const auto &...of) { return hasEdgePixels(of...); }) && isAnyDrawn();
    };
    return runningOf(appearance, asked, isCalledFor, isAnyDrawn);
}

Antialiasing strokeAntialiasing(const Primitives &primitives, const FrameView &frame)
{
    const Appearance &appearance = primitives.appearance;
    const SampledFrame asked{frame, FillRule::Closed, antialiasingOf(appearance)};
    const auto isSoOfAny
        = [&](const auto &is) { return std::ranges::any_of(primitives.shapes, is); };
    return runningOf(
        appearance, asked,
        [&] {
            return isSoOfAny(
                [&](const Shape &shape) { return callsForAntialiasing(shape, asked); });
        },
        [&] {
            return isSoOfAny([&](const Shape &shape) {
                return isStroke(shape) && borderCrossingOf(shape, asked) != BorderCrossing::Outside;
            });
        });
}

PerEffect<EffectVerdict> requirementsWith(const Primitives &primitives, const SampledFrame &where,
                                          const DepthAnswer &depth)
{
    const NeedsTally tally = tallyNeeds(primitives, where);
    PerEffect<EffectVerdict> verdicts;
    for (const Effect effect : allEffects) {
        EffectVerdict &verdict = verdicts[effect];
        if (effect == Effect::Depth) {
            verdict = depthVerdict(primitives, tally, where, depth);
        } else {
            verdict = {verdictOf(effect, tally), effectReason(effect, tally, primitives, where),
                       tally.of[effect].primitives, tally.of[effect].pixels};
        }
        verdict.pixels = std::min(verdict.pixels, pixelsOf(where.frame));
    }
    return verdicts;
}

PerEffect<EffectVerdict> requirementsOf(const Primitives &primitives, const ScanSettings &settings,
                                        const FrameView &frame)
{
    const Antialiasing antialiasing = primitives.appearance.antialiasing;
    return requirementsWith(primitives, sampledFrame(frame, settings, antialiasing),
                            depthQuestion(primitives, settings, frame, antialiasing));
}

} // namespace pixelplumb
