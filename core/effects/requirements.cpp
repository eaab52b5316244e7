// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/requirements.h"

#include "core/effects/effectreason.h"
#include "core/effects/framereach.h"

#include <algorithm>

namespace pixelplumb {

namespace {

std::int64_t pixelsOf(const FrameView &frame) { return std::int64_t(frame.width) * frame.height; }

/// What pixels the triangles in question may touch, at most; all triangles where all are.
std::int64_t pixelsInQuestion(const Primitives &primitives, const FrameView &frame,
                              const DepthAnswer &depth)
{
    std::int64_t pixels = 0;
    for (std::size_t i = 0; i < depth.inQuestion.size(); ++i) {
        if (!depth.inQuestion[i])
            continue;
        const Triangle &triangle = primitives.triangles[i];
        const Antialiasing antialiasing = primitives.appearance.antialiasing;
        pixels += mostPixelsOf(triangle, reachOf(triangle, frame, antialiasing), antialiasing);
    }
    return pixels;
}

EffectVerdict depthVerdict(const Primitives &primitives, const NeedsTally &tally,
                           const FrameView &frame, const DepthAnswer &depth)
{
    EffectVerdict verdict;
    switch (primitives.appearance.depth) {
    case DepthUse::Off:
        verdict.reason = QStringLiteral("the scene says so: what is drawn later covers what was "
                                        "drawn before");
        return verdict;
    case DepthUse::On:
        verdict.reason = QStringLiteral("the scene says so, for all triangles");
        verdict.verdict = tally.drawnTriangles > 0 ? Verdict::CalledFor : Verdict::NotCalledFor;
        verdict.primitives = tally.drawnTriangles;
        verdict.pixels = tally.drawnTriangles > 0 ? pixelsOf(frame) : 0;
        return verdict;
    case DepthUse::Auto:
        break;
    }
    return {depth.verdict, depthReason(depth), depth.countInQuestion(),
            pixelsInQuestion(primitives, frame, depth)};
}

Verdict verdictOf(Effect effect, const NeedsTally &tally)
{
    if (tally.of[effect].primitives > 0)
        return Verdict::CalledFor;
    const bool isInDoubt = effect == Effect::Clipping && tally.mayCross > 0;
    return isInDoubt ? Verdict::NotRuledOut : Verdict::NotCalledFor;
}

} // namespace

PerEffect<EffectVerdict> requirementsWith(const Primitives &primitives,
                                          const ScanSettings &settings, const FrameView &frame,
                                          const DepthAnswer &depth)
{
    const NeedsTally tally = tallyNeeds(primitives, frame);
    PerEffect<EffectVerdict> verdicts;
    for (const Effect effect : allEffects) {
        EffectVerdict &verdict = verdicts[effect];
        if (effect == Effect::Depth) {
            verdict = depthVerdict(primitives, tally, frame, depth);
        } else {
            verdict = {verdictOf(effect, tally),
                       effectReason(effect, tally, primitives, settings, frame),
                       tally.of[effect].primitives, tally.of[effect].pixels};
        }
        verdict.pixels = std::min(verdict.pixels, pixelsOf(frame));
    }
    return verdicts;
}

PerEffect<EffectVerdict> requirementsOf(const Primitives &primitives, const ScanSettings &settings,
                                        const FrameView &frame)
{
    const DepthAnswer depth
        = depthQuestion(primitives, settings, frame, primitives.appearance.antialiasing);
    return requirementsWith(primitives, settings, frame, depth);
}

} // namespace pixelplumb
