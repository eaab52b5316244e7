// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/shade/linecolours.h"

/// What all line methods have in common.
namespace pixelplumb {

template <class Kernel>
bool drawLines(const Run &run, FrameView frame, const ProgressListener &listener)
{
    return withDrawnColours(
        run, [&](const Run &drawn) { return drawWith<Kernel>(drawn, frame, listener); });
}

template <class Kernel>
std::unique_ptr<ScanTrace> traceLines(const Run &run, FrameView frame, const TraceOptions &options)
{
    return withDrawnColours(
        run, [&](const Run &drawn) { return traceWith<Kernel>(drawn, frame, options); });
}

/// The common part of all line methods. The names, the source, the summary and the listing are the
/// method's own.
template <class Kernel>
Method lineMethod()
{
    Method method = methodOf<Kernel>();
    method.draw = drawLines<Kernel>;
    method.trace = traceLines<Kernel>;
    method.family = MethodFamily::Lines;
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.kinds = {PrimitiveKind::Line};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = "a line has no inside that an edge could bound";
    return method;
}

/// The colour at a pixel, in a listing of which Δx is the longer side and x₀ the end at its start.
inline PseudocodeLine coloursAlongLine()
{
    return {
        1, "R ← R₀ + (x − x₀)·(R₁ − R₀)/Δx if Δx > 0, else R₀; G and B likewise", {Moment::First}};
}

} // namespace pixelplumb
