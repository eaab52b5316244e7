// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelhistory.h"

#include "core/methods/stroketruth.h"
#include "core/oracle/effectoracle.h"
#include "core/oracle/strokeoracle.h"
#include "core/runs/explain/carriednumbers.h"
#include "core/runs/explain/edgename.h"
#include "core/runs/explain/pixelreason.h"
#include "core/runs/spanheadings.h"
#include "core/runs/undrawn.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The truth of one primitive at a pixel.
void judge(PixelAttempt &attempt, const TracedScene &traced)
{
    const auto &[x, y] = std::pair(attempt.x, attempt.y);
    const Primitives &primitives = traced.primitives;
    if (attempt.kind == PrimitiveKind::Triangle) {
        const Triangle &triangle = primitives.triangles[attempt.primitive];
        const BoundaryRule rule = boundaryRuleOf(traced.scene);
        attempt.verdict = oracle::judge(triangle, rule, x, y);
        if (traced.shading())
            attempt.verdict.covered
                = oracle::coversPart(triangle, rule, traced.antialiasing(), x, y);
    } else {
        attempt.verdict.covered
            = oracle::covers(primitives.shape(attempt.primitive), primitives.appearance,
                             strokeTruthOf(traced.method), traced.scene.frame.origin, x, y);
    }
}

/// The position after the last step of a primitive.
std::size_t endOf(const ScanTrace &trace, std::size_t primitive)
{
    return primitive + 1 < trace.primitiveCount() ? trace.indexOfSetUp(primitive + 1)
                                                  : trace.stepCount();
}

/// What the run did at the pixel.
void recall(PixelAttempt &attempt, const ScanTrace &trace)
{
    attempt.decided = trace.stepCount();
    if (attempt.primitive >= trace.primitiveCount())
        return;
    attempt.decided = endOf(trace, attempt.primitive);
    if (const auto visit = trace.visitOf(attempt.primitive, attempt.x, attempt.y)) {
        const std::size_t span = trace.spanOf(*visit);
        attempt.span = trace.span(span);
        attempt.spanHeading = spanHeading(trace, span);
        attempt.sample = trace.samples(span)[*visit - trace.firstSampleOf(span)];
        attempt.step = trace.indexOfSample(*visit);
        attempt.decided = attempt.step + 1;
        attempt.change = trace.changes()[*visit];
        attempt.written = attempt.change.isWritten();
        return;
    }
    if (const auto span = trace.spanNear(attempt.primitive, attempt.x, attempt.y)) {
        attempt.decided
            = trace.indexOfSpan(*span) + 1 + trace.endSampleOf(*span) - trace.firstSampleOf(*span);
        attempt.span = trace.span(*span);
        attempt.spanHeading = spanHeading(trace, *span);
    }
}

/// Adds the exact numbers for those that the run used at the visited sample.
void recallExactly(PixelAttempt &attempt, const TracedScene &traced)
{
    if (!attempt.sample)
        return;
    const ExactSample exact = exactSamplesOf(traced, traced.trace->stepAt(attempt.step).span,
                                             std::span(&*attempt.sample, 1))
                                  .front();
    attempt.exactColour = exact.colour;
    for (const std::size_t i : carriedNumbers(traced, attempt.primitive)) {
        if (i >= attempt.sample->cells.size() || attempt.sample->cells[i].isNone())
            continue;
        attempt.carried.push_back({traced.trace->numbers().sample[i].title,
                                   attempt.sample->cells[i],
                                   i < exact.cells.size() ? exact.cells[i] : Quantity()});
    }
}

/// Whether the box of a triangle or line, a line's with a pixel on each side, holds the pixel, or
/// the run visited it; for another shape true. If not, it cannot have painted the pixel.
bool mayHavePainted(const TracedScene &traced, std::size_t primitive, std::int64_t x,
                    std::int64_t y)
{
    const Primitives &primitives = traced.primitives;
    if (!primitives.isTriangle(primitive) && primitives.kindOf(primitive) != PrimitiveKind::Line)
        return true;
    const LatticePoint sample = latticePixel(x, y);
    const auto isInBox = [&sample](const auto &vertices, Lattice margin) {
        const auto [left, right] = std::ranges::minmax(
            vertices, {}, [](const Vertex &vertex) { return vertex.position.x; });
        const auto [low, high] = std::ranges::minmax(
            vertices, {}, [](const Vertex &vertex) { return vertex.position.y; });
        return sample.x >= left.position.x - margin && sample.x <= right.position.x + margin
            && sample.y >= low.position.y - margin && sample.y <= high.position.y + margin;
    };
    // Antialiased, a pixel is painted where its square is met.
    const bool isInside = primitives.isTriangle(primitive)
        ? isInBox(primitives.triangles[primitive].vertices, unitsPerPixel / 2)
        : isInBox(primitives.shape(primitive).vertices, unitsPerPixel);
    return isInside
        || (primitive < traced.trace->primitiveCount()
            && traced.trace->visitOf(primitive, x, y).has_value());
}

} // namespace

PixelAttempt pixelAttempt(const TracedScene &traced, std::size_t primitive, std::int64_t x,
                          std::int64_t y)
{
    PixelAttempt attempt;
    attempt.primitive = primitive;
    attempt.x = x;
    attempt.y = y;
    attempt.kind = traced.primitives.kindOf(primitive);
    judge(attempt, traced);
    recall(attempt, *traced.trace);
    recallExactly(attempt, traced);
    if (attempt.hasEdges()) {
        const SetUpRecord setUp = primitive < traced.trace->primitiveCount()
            ? traced.trace->setUp(primitive)
            : SetUpRecord();
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            attempt.edgeNames[edge]
                = edgeName(setUp, attempt.verdict.edges[edge].from, attempt.verdict.edges[edge].to);
    }
    attempt.reason = reasonOf(attempt, traced);
    return attempt;
}

std::vector<PixelAttempt> pixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    std::vector<PixelAttempt> attempts;
    for (std::size_t primitive = 0; primitive < traced.primitives.size(); ++primitive) {
        if (isDrawn(traced.primitives, primitive, *traced.method))
            attempts.push_back(pixelAttempt(traced, primitive, x, y));
    }
    return attempts;
}

BriefPixelHistory briefPixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                    const ListedRefusals &most)
{
    BriefPixelHistory history;
    std::size_t inBox = 0;
    std::size_t outside = 0;
    for (std::size_t primitive = 0; primitive < traced.primitives.size(); ++primitive) {
        if (!isDrawn(traced.primitives, primitive, *traced.method))
            continue;
        const bool isInside = mayHavePainted(traced, primitive, x, y);
        if (!isInside && ++outside > most.outside) {
            ++history.furtherRefusals;
            continue;
        }
        PixelAttempt attempt = pixelAttempt(traced, primitive, x, y);
        const bool isRefusal = !attempt.written && !attempt.verdict.covered;
        if (isInside && isRefusal && ++inBox > most.inBox)
            ++history.furtherRefusals;
        else
            history.attempts.push_back(std::move(attempt));
    }
    return history;
}

bool leaveOutAhead(BriefPixelHistory &history, std::size_t position)
{
    const bool hasSome = std::erase_if(history.attempts, [position](const PixelAttempt &attempt) {
        return attempt.decided > position;
    });
    if (hasSome)
        history.furtherRefusals = 0; // those come after the ones that are ahead
    return hasSome;
}

} // namespace pixelplumb
