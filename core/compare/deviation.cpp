// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/deviation.h"

#include "core/compare/exactbounds.h"
#include "core/methods/stroketruth.h"
#include "core/oracle/oracle.h"
#include "core/oracle/strokeoracle.h"
#include "core/runs/undrawn.h"
#include "core/scan/interval.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

bool isSame(const WrittenFrame &a, const WrittenFrame &b, std::int64_t x, std::int64_t y)
{
    return *a.view().at(x, y) == *b.view().at(x, y);
}

int byteDistance(const Colour &a, const Colour &b)
{
    int largest = 0;
    for (std::size_t channel = 0; channel < a.channels.size(); ++channel)
        largest = std::max(largest, std::abs(int(a.channels[channel]) - int(b.channels[channel])));
    return largest;
}

bool isTrulyCovered(const JudgedRun &run, std::size_t primitive, std::int64_t x, std::int64_t y)
{
    const Primitives &primitives = *run.primitives;
    if (!isDrawn(primitives, primitive, *run.traced->method))
        return false;
    if (!primitives.isTriangle(primitive))
        return oracle::covers(primitives.shape(primitive), primitives.appearance,
                              strokeTruthOf(run.traced->method), run.traced->scene.frame.origin, x,
                              y);
    const Triangle &triangle = primitives.triangles[primitive];
    return isInBox(triangle, x, y)
        && oracle::covers(triangle, boundaryRuleOf(run.traced->scene), x, y);
}

bool isWrittenBy(const JudgedRun &run, std::size_t primitive, std::int64_t x, std::int64_t y)
{
    const ScanTrace &trace = *run.traced->trace;
    if (primitive >= trace.primitiveCount())
        return false;
    const std::optional<std::size_t> visit = trace.visitOf(primitive, x, y);
    return visit && trace.changes()[*visit].isWritten();
}

/// Finds the topmost primitive at the pixel, in the run or the truth: one that the run left out or
/// drew outside its place, or else the one whose colour is visible.
void findCulprit(Deviation &deviation, const JudgedRun &run, std::int64_t x, std::int64_t y)
{
    for (std::size_t above = run.primitives->size(); above > 0; --above) {
        const std::size_t primitive = above - 1;
        const bool covered = isTrulyCovered(run, primitive, x, y);
        const bool written = isWrittenBy(run, primitive, x, y);
        if (!covered && !written)
            continue;
        deviation.primitive = primitive;
        if (covered != written)
            deviation.kind = covered ? Difference::Missing : Difference::Extra;
        return;
    }
}

std::optional<std::size_t> spanAt(const ScanTrace &trace, std::size_t primitive, std::int64_t x,
                                  std::int64_t y)
{
    if (const std::optional<std::size_t> visit = trace.visitOf(primitive, x, y))
        return trace.spanOf(*visit);
    return trace.spanNear(primitive, x, y);
}

/// Whether the arithmetic can represent the coordinates from which the increments start.
bool holdsVertices(Arithmetic arithmetic, const Triangle &triangle)
{
    return std::ranges::all_of(triangle.vertices, [arithmetic](const Vertex &vertex) {
        const auto holds = [arithmetic](Lattice coordinate) {
            const Quantity exact = Quantity::rational(coordinate, unitsPerPixel);
            return errorOf(roundedTo(arithmetic, exact), exact) == 0;
        };
        return holds(vertex.position.x) && holds(vertex.position.y);
    });
}

/// Whether a bound includes a sample; along the span, row walks follow the same rules as columns.
bool letsIn(DecidingBound side, const Quantity &bound, std::int64_t sample, FillRule rule)
{
    const double above = errorOf(bound, Quantity::integer(sample)); // bound − sample
    const Interval interval = columnIntervals(rule).rows;
    if (side == DecidingBound::Lower)
        return above < 0 || (above == 0 && ownsFirst(interval));
    return above > 0 || (above == 0 && ownsLast(interval));
}

/// Finds the bound that decided wrongly: used and exact disagree on the sample.
void findBound(Deviation &deviation, const JudgedRun &run, std::int64_t x, std::int64_t y)
{
    if (!deviation.span || !run.primitives->isTriangle(*deviation.primitive))
        return;
    const SpanRecord span = run.traced->trace->span(*deviation.span);
    const auto exact = exactBoundsOn(run.primitives->triangles[*deviation.primitive], span.place);
    if (!exact || span.lower.isNone() || span.upper.isNone())
        return;
    const FillRule rule = run.traced->scene.settings.fillRule;
    const std::int64_t sample = span.place.axis == SpanAxis::Column ? y : x;
    const auto look = [&](DecidingBound side, const Quantity &used, const Quantity &truly) {
        if (letsIn(side, used, sample, rule) == letsIn(side, truly, sample, rule))
            return;
        deviation.bound = side;
        deviation.used = used;
        deviation.exact = truly;
    };
    look(DecidingBound::Upper, span.upper, exact->upper);
    look(DecidingBound::Lower, span.lower, exact->lower);
}

Disagreement reasonOf(const Deviation &deviation, const JudgedRun &run, std::int64_t x,
                      std::int64_t y)
{
    const Arithmetic arithmetic = run.traced->scene.settings.arithmetic;
    if (arithmetic == Arithmetic::Exact || !run.traced->method->supports(Arithmetic::Exact)
        || (run.inExactArithmetic && isSame(*run.inExactArithmetic, *run.drawn, x, y)))
        return Disagreement::Method;
    if (deviation.kind == Difference::Colour
        && byteDistance(run.drawn->colourAt(x, y), run.truth->colourAt(x, y)) <= 1)
        return Disagreement::Rounding;
    const ScanTrace &trace = *run.traced->trace;
    if (!deviation.primitive || *deviation.primitive >= trace.primitiveCount())
        return Disagreement::NotRecorded;
    if (trace.setUp(*deviation.primitive).rejection == PrimitiveRejection::NotRepresentable)
        return Disagreement::Precision;
    if (!isIncremental(*run.traced->method))
        return Disagreement::Precision;
    if (run.primitives->isTriangle(*deviation.primitive)
        && !holdsVertices(arithmetic, run.primitives->triangles[*deviation.primitive]))
        return Disagreement::Precision;
    if (deviation.bound == DecidingBound::None)
        return trace.isCut() && !deviation.span ? Disagreement::NotRecorded : Disagreement::Drift;
    // Would the exact bound, rounded once to the number type, have decided correctly?
    const bool isColumn = trace.placeOf(*deviation.span).axis == SpanAxis::Column;
    const std::int64_t sample = isColumn ? y : x;
    const FillRule rule = run.traced->scene.settings.fillRule;
    const Quantity rounded = roundedTo(arithmetic, deviation.exact);
    return letsIn(deviation.bound, rounded, sample, rule)
            == letsIn(deviation.bound, deviation.exact, sample, rule)
        ? Disagreement::Drift
        : Disagreement::Precision;
}

Quantity roundedToFixed(const Quantity &exact, int fractionBits)
{
    const Int128 scale = Int128(1) << fractionBits;
    const Int128 doubled = 2 * exact.numerator() * scale + exact.denominator();
    return Quantity::rational(floorDivide(doubled, 2 * exact.denominator()), scale);
}

} // namespace

Difference differenceAt(const JudgedRun &run, std::int64_t x, std::int64_t y)
{
    const bool written = run.drawn->isWritten(x, y);
    const bool covered = run.truth->isWritten(x, y);
    return written == covered && isSame(*run.drawn, *run.truth, x, y)
        ? Difference::None
        : differenceOf(written, covered);
}

Deviation deviationAt(const JudgedRun &run, std::int64_t x, std::int64_t y)
{
    Deviation deviation;
    deviation.kind = differenceAt(run, x, y);
    if (deviation.kind == Difference::None)
        return deviation;
    findCulprit(deviation, run, x, y);
    const ScanTrace &trace = *run.traced->trace;
    if (deviation.primitive && *deviation.primitive < trace.primitiveCount()) {
        deviation.span = spanAt(trace, *deviation.primitive, x, y);
        if (run.primitives->isTriangle(*deviation.primitive))
            deviation.isTie = liesOnBoundary(run.primitives->triangles[*deviation.primitive], x, y);
        if (deviation.kind != Difference::Colour)
            findBound(deviation, run, x, y);
    }
    deviation.reason = reasonOf(deviation, run, x, y);
    return deviation;
}

bool isIncremental(const NumberDescription &number)
{
    const qsizetype arrow = number.formula.indexOf(u'←');
    if (arrow < 0)
        return false;
    const QString name = number.formula.first(arrow).trimmed();
    return !name.isEmpty() && number.formula.sliced(arrow + 1).contains(name);
}

bool isIncremental(const Method &method)
{
    const auto accumulates = [](const NumberDescription &number) {
        return number.comparison == Comparison::WithExact && isIncremental(number);
    };
    return std::ranges::any_of(method.numbers.span, accumulates)
        || std::ranges::any_of(method.numbers.sample, accumulates);
}

Quantity roundedTo(Arithmetic arithmetic, const Quantity &exact)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        return exact;
    case Arithmetic::Float32:
        return Quantity::of(float(exact.toDouble()));
    case Arithmetic::Float64:
        return Quantity::of(exact.toDouble());
    case Arithmetic::Fixed16:
        return roundedToFixed(exact, 16);
    case Arithmetic::Fixed32:
        return roundedToFixed(exact, 32);
    }
    return exact;
}

} // namespace pixelplumb
