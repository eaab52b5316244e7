// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/shapereason.h"

#include "core/oracle/lineoracle.h"
#include "core/polygons/contours.h"
#include "core/runs/explain/edgerefusal.h"
#include "core/runs/spanheadings.h"
#include "core/scan/choicenames.h"
#include "core/trace/namednumbers.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pixelplumb {

namespace {

/// Whether a sample lies on an edge, its ends included.
bool isOn(const ContourEdge &edge, const LatticePoint &sample)
{
    const auto [first, last] = std::minmax(edge.from, edge.to);
    return first <= sample && sample <= last && doubledArea(first, last, sample) == 0;
}

/// Says that only the fill rule keeps a sample out; empty if none of the polygon's edges has it.
QString tieOfPolygonText(const Shape &polygon, FillRule rule, const LatticePoint &sample)
{
    const auto edges = contoursOf(polygon).edges;
    const auto found = std::ranges::find_if(
        edges, [&sample](const ContourEdge &edge) { return isOn(edge, sample); });
    return found == edges.end()
        ? QString()
        : u" The sample lies exactly on edge %1, and the rule %2 leaves it outside."_s
              .arg(found - edges.begin())
              .arg(nameText(nameOf(rule)));
}

/// Says that the line is equally near to the pixel and to the one beside it; empty if it is not, or
/// if the truth has neither.
QString tieOfLineText(const Shape &line, const PixelAttempt &attempt)
{
    const oracle::TrueLine truth(line.vertices[0], line.vertices[1]);
    const std::int64_t along = truth.isSteep() ? attempt.y : attempt.x;
    const std::int64_t across = truth.isSteep() ? attempt.x : attempt.y;
    if (along < truth.first() || along >= truth.end() || !truth.isMidwayAt(along))
        return {};
    const std::int64_t greater = truth.nearestAt(along);
    if (across != greater && across != greater - 1)
        return {};
    const QString axis = truth.isSteep() ? u"x"_s : u"y"_s;
    return u" A tie: the exact line passes midway between %1 = %2 and %1 = %3 "
           "here, and the truth takes the greater one."_s.arg(axis)
               .arg(greater - 1)
               .arg(greater);
}

/// What a step says, where its numbers may be rounded "as computed": exact ones stand beside them.
QString stepText(const TracedScene &traced, std::size_t span)
{
    const QString told = traced.trace->spanWords(span).sentence;
    const QString pattern = traced.scene.settings.arithmetic == Arithmetic::Exact
        ? u" %1: %2"_s
        : u" %1, as computed: %2"_s;
    return told.isEmpty() ? told : pattern.arg(spanHeading(*traced.trace, span), told);
}

/// The first of the written samples that are nearest to the pixel; none if nothing was written.
std::optional<std::size_t> nearestWritten(const ScanTrace &trace, const PixelAttempt &attempt)
{
    std::optional<std::size_t> nearest;
    std::int64_t least = 0;
    const std::size_t end = trace.endSampleOf(trace.endSpanOf(attempt.primitive) - 1);
    for (std::size_t i = trace.firstSampleOf(trace.firstSpanOf(attempt.primitive)); i < end; ++i) {
        const PixelChange &change = trace.changes()[i];
        const std::int64_t distance = (change.x - attempt.x) * (change.x - attempt.x)
            + (change.y - attempt.y) * (change.y - attempt.y);
        if (change.isWritten() && (!nearest || distance < least)) {
            nearest = i;
            least = distance;
        }
    }
    return nearest;
}

/// The steps that wrote the four pixels next to this one show where a curve goes; if it passes none
/// of them, the step that wrote the nearest.
QString stepsNextToText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    std::vector<std::size_t> spans;
    constexpr std::array<std::array<int, 2>, 4> sides = {{{0, 1}, {0, -1}, {1, 0}, {-1, 0}}};
    for (const auto &[right, up] : sides) {
        const auto visit = trace.visitOf(attempt.primitive, attempt.x + right, attempt.y + up);
        if (!visit || !trace.changes()[*visit].isWritten())
            continue;
        if (const std::size_t span = trace.spanOf(*visit); std::ranges::count(spans, span) == 0)
            spans.push_back(span);
    }
    if (spans.empty()) {
        if (const auto nearest = nearestWritten(trace, attempt))
            spans.push_back(trace.spanOf(*nearest));
        else if (!trace.isCut())
            return u" None of its steps writes a pixel of the frame."_s;
    }
    std::ranges::sort(spans);
    QString text;
    for (const std::size_t span : spans)
        text += stepText(traced, span);
    return text;
}

/// Whether a step wrote into the frame.
bool isInFrame(const ScanTrace &trace, std::size_t span)
{
    return trace.firstSampleOf(span) < trace.endSampleOf(span);
}

/// "rows 2 … 3", "row 3"
QString linesText(const QString &kind, std::int64_t first, std::int64_t last)
{
    return first == last ? u"%1 %2"_s.arg(kind).arg(first)
                         : u"%1s %2 … %3"_s.arg(kind).arg(first).arg(last);
}

/// That a line's walk has no step on the pixel's column or row.
QString noStepText(const PixelAttempt &attempt, const ScanTrace &trace)
{
    const std::size_t first = trace.firstSpanOf(attempt.primitive);
    const std::size_t end = trace.endSpanOf(attempt.primitive);
    if (trace.isCut())
        return {};
    const bool isRow = trace.placeOf(first).axis == SpanAxis::Row;
    std::vector<std::int64_t> places;
    for (std::size_t span = first; span < end; ++span) {
        if (isInFrame(trace, span))
            places.push_back(trace.placeOf(span).coordinate);
    }
    const QString kind = isRow ? u"row"_s : u"column"_s;
    const auto [least, greatest] = std::ranges::minmax_element(places);
    return u" The walk along the line has no step on the %1 %2: in the frame it has %3."_s.arg(kind)
        .arg(isRow ? attempt.y : attempt.x)
        .arg(places.empty() ? u"none"_s : u"steps on the "_s + linesText(kind, *least, *greatest));
}

/// That a circle ends before the pixel's column or row; `first` and `last` are those that it meets.
QString beyondCircleText(const PixelAttempt &attempt, const QString &kind, std::int64_t place,
                         std::int64_t first, std::int64_t last)
{
    return u" The %1 %2 does not meet the %3, which meets the frame's %4."_s.arg(kind)
        .arg(place)
        .arg(nameOf(attempt.kind), linesText(kind, first, last));
}

/// The first column of steps that go from column to column; none where they do not.
std::optional<std::int64_t> firstColumnOf(const ScanTrace &trace, std::size_t primitive)
{
    const NumberDescription &first = trace.numbers().span.front();
    if (first.id != u"x"_s || first.group != NumberGroup::Position)
        return std::nullopt;
    return std::int64_t(trace.span(trace.firstSpanOf(primitive)).cells.front().numerator());
}

/// The step of the pixel's column, or that there is none.
QString stepOfColumnText(const PixelAttempt &attempt, const TracedScene &traced,
                         std::int64_t firstColumn)
{
    const std::int64_t x = attempt.x;
    const std::size_t first = traced.trace->firstSpanOf(attempt.primitive);
    const auto count = std::int64_t(traced.trace->endSpanOf(attempt.primitive) - first);
    if (x >= firstColumn && x < firstColumn + count)
        return stepText(traced, first + std::size_t(x - firstColumn));
    return traced.trace->isCut()
        ? QString()
        : beyondCircleText(attempt, u"column"_s, x, firstColumn, firstColumn + count - 1);
}

/// That a fill has no span on the pixel's row.
QString noRowText(const PixelAttempt &attempt, const ScanTrace &trace)
{
    if (attempt.kind == PrimitiveKind::Circle || attempt.kind == PrimitiveKind::Ellipse)
        return beyondCircleText(attempt, u"row"_s, attempt.y,
                                trace.placeOf(trace.firstSpanOf(attempt.primitive)).coordinate,
                                trace.placeOf(trace.endSpanOf(attempt.primitive) - 1).coordinate);
    return u" The row %1 crosses none of its %2."_s.arg(attempt.y).arg(
        hasNumber(trace.numbers().span, u"triangle"_s) ? u"triangles"_s : u"edges"_s);
}

/// What the span says in which the pixel was passed over, or between which bounds it fills.
QString spanText(const TracedScene &traced, std::size_t span)
{
    const SpanRecord record = traced.trace->span(span);
    if (const QString told = stepText(traced, span); !told.isEmpty() || record.lower.isNone())
        return told;
    return u" %1: %2."_s.arg(spanHeading(*traced.trace, span),
                             boundsText(record, traced.scene.settings.arithmetic));
}

} // namespace

QString visitText(const PixelAttempt &attempt, const ScanTrace &trace)
{
    if (!attempt.sample)
        return {};
    const TraceStep step = trace.stepAt(attempt.step);
    return trace.sampleWords(step.span, step.sample - trace.firstSampleOf(step.span)).sentence;
}

bool isDecidedByOutline(const PixelAttempt &attempt, const ScanTrace &trace)
{
    return attempt.kind == PrimitiveKind::Triangle && hasNumber(trace.numbers().span, "edge_low");
}

bool isUntested(const PixelAttempt &attempt, const ScanTrace &trace)
{
    const auto &numbers = trace.numbers().span;
    const bool isOfBox = hasNumber(numbers, "x_min") || hasNumber(numbers, "y_min");
    return !attempt.sample && !trace.isCut() && isOfBox;
}

QString stepBesideText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    if (attempt.primitive >= trace.primitiveCount())
        return {};
    const auto step = trace.spanNear(attempt.primitive, attempt.x, attempt.y);
    if (attempt.kind == PrimitiveKind::Triangle)
        return step && isDecidedByOutline(attempt, trace) ? stepText(traced, *step) : QString();
    const std::size_t first = trace.firstSpanOf(attempt.primitive);
    if (first == trace.endSpanOf(attempt.primitive))
        return {};
    const SpanAxis axis = trace.placeOf(first).axis;
    if (axis == SpanAxis::Free) {
        const auto column = firstColumnOf(trace, attempt.primitive);
        return column ? stepOfColumnText(attempt, traced, *column)
                      : stepsNextToText(attempt, traced);
    }
    if (step)
        return attempt.sample && attempt.kind != PrimitiveKind::Line ? QString()
                                                                     : spanText(traced, *step);
    if (attempt.kind == PrimitiveKind::Line)
        return noStepText(attempt, trace);
    if (trace.isCut())
        return {};
    // The lines of an outline go along columns and rows.
    return axis == SpanAxis::Row && !hasNumber(trace.numbers().span, "p_k")
        ? noRowText(attempt, trace)
        : stepsNextToText(attempt, traced);
}

QString stepOfPixelText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    if (!attempt.written)
        return {};
    const TraceStep step = trace.stepAt(attempt.step);
    const QString told = visitText(attempt, trace);
    // What decides samples of a row is how its edges cross it.
    const bool hasCrossings = attempt.kind == PrimitiveKind::Polygon && !attempt.verdict.covered
        && trace.placeOf(step.span).axis == SpanAxis::Row;
    if (told.isEmpty() || hasCrossings)
        return (told.isEmpty() ? told : u' ' + told) + stepText(traced, step.span);
    return u' ' + told;
}

QString tieOfShapeText(const PixelAttempt &attempt, const TracedScene &traced)
{
    if (attempt.kind == PrimitiveKind::Polygon)
        return tieOfPolygonText(traced.primitives.shape(attempt.primitive),
                                traced.scene.settings.fillRule, latticePixel(attempt.x, attempt.y));
    if (attempt.kind == PrimitiveKind::Line)
        return tieOfLineText(traced.primitives.shape(attempt.primitive), attempt);
    return {};
}

QString approximationText(const ScanTrace &trace, std::size_t primitive)
{
    if (primitive >= trace.primitiveCount())
        return {};
    const SetUpRecord setUp = trace.setUp(primitive);
    const NamedNumbers numbers(trace.numbers().setUp, setUp.cells);
    if (const Quantity moved = numbers[u"moved"_s]; !moved.isNone() && moved.toDouble() > 0)
        return u" Its crossings were moved to multiples of 1/256 px, by %1 px at "
               "most, and tilt the edges that meet there."_s.arg(moved.toDouble(), 0, 'g', 3);
    if (!numbers[u"curves"_s].isNone())
        return u" What was filled are its chords, which leave the curves by 1/32 px at most."_s;
    return {};
}

} // namespace pixelplumb
