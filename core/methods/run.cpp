// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/run.h"

#include "core/methods/method.h"
#include "core/methods/stroketruth.h"
#include "core/oracle/truepicture.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool drawsTriangles(const Method *method)
{
    return !method || method->draws(PrimitiveKind::Triangle);
}

/// Calls function(primitives) with those that the run's method draws.
template <class Function>
decltype(auto) withDrawn(const Run &run, const Function &function)
{
    return run.drawsAll() ? function(run.primitives)
                          : function(drawnBy(run.method, run.primitives));
}

EffectPlan newPlan(const Run &run, const FrameView &frame)
{
    return withDrawn(run,
                     [&](const Primitives &drawn) { return planFor(drawn, run.settings, frame); });
}

} // namespace

Primitives drawnBy(const Method *method, Primitives primitives)
{
    if (!method)
        return primitives;
    const std::size_t all = primitives.size();
    if (!drawsTriangles(method))
        primitives = {{}, std::move(primitives.shapes), {}, std::move(primitives.appearance)};
    std::erase_if(primitives.shapes, [&](const Shape &shape) { return !method->draws(shape); });
    primitives.isPart = primitives.size() < all;
    return primitives;
}

Run::Run(const Method *drawnBy, Primitives all, const ScanSettings &under, const FrameView &frame,
         Kernels drawnWith)
    : method(drawnBy)
    , primitives(std::move(all))
    , settings(under)
    , kernels(drawnWith)
{
    // Most scenes carry nothing and need no plan.
    if (!primitives.attributes.empty() || primitives.appearance.asksForEffects())
        plan = newPlan(*this, frame);
}

bool Run::drawsAll() const
{
    return !method
        || ((primitives.triangles.empty() || drawsTriangles(method))
            && std::ranges::all_of(primitives.shapes,
                                   [this](const Shape &shape) { return method->draws(shape); }));
}

const EffectPlan *Run::shading() const
{
    if (!plan || primitives.triangles.empty() || !drawsTriangles(method))
        return nullptr;
    // The plain kernels interpolate whatever colours there are.
    const bool losesColours = primitives.appearance.forced[Effect::SmoothColour] == Forcing::Off
        && plan->verdicts[Effect::SmoothColour].verdict == Verdict::CalledFor;
    return plan->isPlain() && !losesColours ? nullptr : &*plan;
}

Antialiasing Run::antialiasing() const { return plan ? plan->antialiasing : Antialiasing::None; }

Antialiasing Run::strokeAntialiasing() const
{
    return plan ? plan->strokeAntialiasing : Antialiasing::None;
}

bool Run::draw(FrameView frame, const ProgressListener &listener) const
{
    if (method)
        return method->draw(*this, frame, listener);
    drawTruth(frame);
    return true;
}

std::unique_ptr<ScanTrace> Run::trace(FrameView frame, const TraceOptions &options) const
{
    return method->trace(*this, frame, options);
}

void Run::drawTruth(FrameView frame) const
{
    withDrawn(*this, [&](const Primitives &drawn) {
        oracle::drawPicture(drawn, settings, shading(), frame, strokeTruthOf(method));
    });
}

EffectPlan planOf(const Run &run, const FrameView &frame)
{
    return run.plan ? *run.plan : newPlan(run, frame);
}

} // namespace pixelplumb
