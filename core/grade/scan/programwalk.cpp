// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/programwalk.h"

#include "core/grade/rounding/boundedside.h"
#include "core/scan/mistakes/mistakenscan.h"

namespace pixelplumb {

namespace {

/// Keeps the runs of a walk, until one is not acceptable.
struct RunKeeper {
    static constexpr LevelDetail detail = LevelDetail::Whole;

    TriangleRuns &triangle;
    SpanOrder order;

    std::int64_t spanOf(std::int64_t seen) const
    {
        return order == SpanOrder::Ascending ? seen : -seen;
    }
    bool hears(std::int64_t span) const { return triangle.isAskedFor(spanOf(span)); }
    template <class Numbers>
    bool walked(const MistakenSpan<Numbers> &span)
    {
        triangle.runs.push_back({spanOf(span.span), span.samples.firstDrawn, span.samples.endDrawn,
                                 std::move(span.levels.whole), span.samples.firstDrawn});
        triangle.isRefused
            = span.isFinal && triangle.mayBe && !triangle.mayBe(triangle.runs.back());
        return !triangle.isRefused;
    }
};

template <class Numbers>
bool walkIn(TriangleRuns &triangle, const ScanBugs &bugs)
{
    const SpanOrder order = orderOf(bugs, triangle.order);
    triangle.runs.clear();
    RunKeeper keeper{triangle, order};
    if (!triangle.side)
        return walkMistaken<Numbers>(triangle, bugs, WalkSide(), keeper);
    const BoundedSide side(seenFrom(triangle, order).triangle, *triangle.side);
    return walkMistaken<Numbers>(triangle, bugs, side, keeper);
}

} // namespace

bool walkAs(TriangleRuns &triangle, const ScanBugs &bugs)
{
    if (triangle.side)
        return walkIn<MistakenNumbers<double>>(triangle, bugs);
    switch (triangle.settings.arithmetic) {
    case Arithmetic::Exact:
        return walkIn<MistakenNumbers<Fraction>>(triangle, bugs);
    case Arithmetic::Float32:
        return walkIn<MistakenNumbers<float>>(triangle, bugs);
    case Arithmetic::Float64:
        return walkIn<MistakenNumbers<double>>(triangle, bugs);
    case Arithmetic::Fixed16:
        return walkIn<MistakenNumbers<FixedPoint16>>(triangle, bugs);
    case Arithmetic::Fixed32:
        return walkIn<MistakenNumbers<FixedPoint32>>(triangle, bugs);
    }
    return false;
}

Redrawing redrawingBy(const ScanBugs &bugs)
{
    const auto walk = [bugs](TriangleRuns &triangle) {
        if (!walkAs(triangle, bugs))
            triangle.readRight();
    };
    Redrawing redrawing{walk, bugs.overflow};
    redrawing.findsSamples = true;
    redrawing.walk = std::make_shared<const ScanBugs>(bugs);
    return redrawing;
}

} // namespace pixelplumb
