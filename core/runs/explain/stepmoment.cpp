// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/stepmoment.h"

#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

Moment momentOfSpan(const ScanTrace &trace, const TraceStep &step)
{
    if (const auto told = trace.spanWords(step.span).moment)
        return *told;
    return trace.beginsPart(step.span) ? Moment::Begin : Moment::Span;
}

Moment momentOfSample(const ScanTrace &trace, const TraceStep &step)
{
    if (!trace.changes()[step.sample].isWritten())
        return Moment::Refused;
    return step.sample == trace.firstSampleOf(step.span) ? Moment::First : Moment::Next;
}

/// What runs for a triangle beyond its method's plain kernel.
EffectSet effectsOf(const EffectPlan &plan, std::size_t triangle)
{
    const auto batch = std::ranges::find_if(plan.batches, [triangle](const EffectBatch &candidate) {
        return triangle >= candidate.first && triangle - candidate.first < candidate.count;
    });
    return batch != plan.batches.end() ? batch->effects : EffectSet{};
}

Pseudocode variedCode(Pseudocode code, VariantSet variants)
{
    for (PseudocodeLine &line : code) {
        for (const VariedLine &varied : line.varied) {
            if ((varied.variants.bits & ~variants.bits) == 0)
                line.text = varied.text;
        }
    }
    return code;
}

bool isSegment(const ScanTrace &trace, std::size_t primitive)
{
    return primitive < trace.primitiveCount() && trace.setUp(primitive).zeroArea;
}

/// A triangle without area has no edges that could depart, but a box.
VariantSet variantsFor(const TracedScene &traced, std::size_t primitive)
{
    const VariantSet all = traced.scene.settings.variants;
    return isSegment(*traced.trace, primitive)
        ? VariantSet{all.bits & VariantSet().with(Variant::RoundedBox).bits}
        : all;
}

/// Adds the line that lights the vertices before anything is scanned.
Pseudocode litCode(Pseudocode code, const TracedScene &traced)
{
    if (traced.shading() && traced.shading()->vertexLight)
        code.insert(code.begin(),
                    {0,
                     "R₀, G₀, B₀ ← lit(P₀); P₁ and P₂ likewise — given: lit(P), ambient and, of "
                     "each light, the "
                     "diffuse and specular term",
                     {Moment::SetUp}});
    return code;
}

} // namespace

Moment momentOf(const ScanTrace &trace, std::size_t stepIndex)
{
    const TraceStep step = trace.stepAt(stepIndex);
    switch (step.kind) {
    case StepKind::Span:
        return momentOfSpan(trace, step);
    case StepKind::Sample:
        return momentOfSample(trace, step);
    case StepKind::SetUp:
        break;
    }
    return std::ranges::binary_search(trace.rejectedPrimitives(), step.primitive) ? Moment::Rejected
                                                                                  : Moment::SetUp;
}

Pseudocode pseudocodeOf(const TracedScene &traced, std::size_t primitive)
{
    const bool isShaded = traced.shading() && !traced.method->shadedPseudocode.empty();
    Pseudocode code = underRule(
        linesOf(isSegment(*traced.trace, primitive) ? LineOf::Segment : LineOf::Area,
                isShaded ? traced.method->shadedPseudocode
                         : variedCode(traced.method->pseudocode, variantsFor(traced, primitive))),
        traced.scene.settings.fillRule, traced.scene.frame.origin);
    const EffectSet effects = isShaded ? effectsOf(*traced.shading(), primitive) : EffectSet{};
    const Antialiasing antialiasing
        = isShaded ? traced.antialiasing() : traced.strokeAntialiasing();
    std::erase_if(code, [&](const PseudocodeLine &line) {
        return (line.effect && !contains(effects, *line.effect))
            || (!line.antialiasing.empty()
                && std::ranges::find(line.antialiasing, antialiasing) == line.antialiasing.end());
    });
    return litCode(std::move(code), traced);
}

} // namespace pixelplumb
