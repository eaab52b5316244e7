// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracemarks.h"

#include "core/oracle/oracle.h"
#include "core/polygons/contours.h"
#include "core/trace/namednumbers.h"

#include <algorithm>
#include <set>

namespace pixelplumb {

namespace {

Triangle mirrored(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices)
        std::swap(vertex.position.x, vertex.position.y);
    return triangle;
}

/// A vertex's coordinate across the columns or rows, lattice units.
Lattice placeAcross(SpanAxis axis, const Vertex &vertex)
{
    return axis == SpanAxis::Row ? vertex.position.y : vertex.position.x;
}

/// How far a vertex lies from a column or row, in lattice units.
std::int64_t distanceFrom(const SpanPlace &place, const Vertex &vertex)
{
    return std::abs(placeAcross(place.axis, vertex) - place.coordinate * unitsPerPixel);
}

/// Whether a vertex of the triangle lies next to a span: where the frame ends a walk, none does. A
/// vertex exactly a pixel away is one whose own column or row is not scanned.
bool isAtVertex(const Triangle &triangle, const SpanPlace &place)
{
    const auto across = [&place](const Vertex &vertex) { return placeAcross(place.axis, vertex); };
    const auto [least, most] = std::ranges::minmax(triangle.vertices, {}, across);
    const std::int64_t units = place.coordinate * unitsPerPixel;
    const bool isWithin = across(least) <= units && units <= across(most);
    return std::ranges::any_of(triangle.vertices, [&](const Vertex &vertex) {
        const std::int64_t away = distanceFrom(place, vertex);
        return away < unitsPerPixel || (isWithin && away == unitsPerPixel);
    });
}

/// The column or row nearest to a vertex, less than a pixel away.
std::optional<std::size_t> spanAtVertex(const ScanTrace &trace, std::size_t primitive,
                                        const Vertex &vertex)
{
    std::optional<std::size_t> nearest;
    std::int64_t least = unitsPerPixel;
    for (std::size_t span = trace.firstSpanOf(primitive); span < trace.endSpanOf(primitive);
         ++span) {
        const SpanPlace &place = trace.placeOf(span);
        if (place.axis == SpanAxis::Free || distanceFrom(place, vertex) >= least)
            continue;
        least = distanceFrom(place, vertex);
        nearest = span;
    }
    return nearest;
}

/// Marks vertices within a part: methods that walk a triangle in one part pass the middle vertex
/// there, and those that visit every pixel of the frame all three.
void appendVerticesWithinParts(std::vector<TraceMark> &marks, const ScanTrace &trace,
                               const Triangle &triangle, std::size_t primitive,
                               const std::vector<std::size_t> &ends)
{
    std::set<std::size_t> spans;
    for (const Vertex &vertex : triangle.vertices) {
        const bool isAtEnd = std::ranges::any_of(ends, [&](std::size_t span) {
            return distanceFrom(trace.placeOf(span), vertex) < unitsPerPixel;
        });
        const auto span = isAtEnd ? std::nullopt : spanAtVertex(trace, primitive, vertex);
        if (span && spans.insert(*span).second)
            marks.push_back({trace.indexOfSpan(*span), MarkKind::PartBegins});
    }
}

/// Whether an edge has a sample of the frame on a row, which it crosses or lies in.
bool hasSampleOn(const ContourEdge &edge, std::int64_t row, const FrameSpec &frame)
{
    const std::int64_t first = frame.firstColumn, last = first + frame.width - 1;
    if (edge.from.y == edge.to.y) {
        const auto [left, right] = std::minmax(edge.from.x, edge.to.x);
        return std::max<std::int64_t>(ceilPixel(left), first)
            <= std::min<std::int64_t>(floorPixel(right), last);
    }
    const Int128 rise = edge.to.y - edge.from.y;
    const Int128 place = Int128(edge.from.x) * rise
        + Int128(row * unitsPerPixel - edge.from.y) * (edge.to.x - edge.from.x);
    const Int128 pixel = rise * unitsPerPixel;
    return place % pixel == 0 && place / pixel >= first && place / pixel <= last;
}

/// The rows next to a polygon's vertices.
std::set<std::int64_t> vertexRowsOf(const Shape &polygon)
{
    std::set<std::int64_t> rows;
    for (const Vertex &vertex : polygon.vertices)
        rows.insert(floorPixel(vertex.position.y + halfPixel));
    return rows;
}

/// The rows of the frame on which a sample lies on an edge of a polygon.
std::set<std::int64_t> tieRowsOf(const Shape &polygon, const FrameSpec &frame)
{
    std::set<std::int64_t> rows;
    for (const ContourEdge &edge : contoursOf(polygon).edges) {
        const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
        const std::int64_t first = std::max<std::int64_t>(ceilPixel(low), frame.firstRow);
        const std::int64_t last
            = std::min<std::int64_t>(floorPixel(high), frame.firstRow + frame.height - 1);
        for (std::int64_t row = first; row <= last; ++row) {
            if (hasSampleOn(edge, row, frame))
                rows.insert(row);
        }
    }
    return rows;
}

/// At a walk's ends also where the vertex is on the next row, which is not scanned.
bool isNextTo(const std::set<std::int64_t> &vertexRows, std::int64_t row, bool isAtEnd)
{
    return vertexRows.contains(row)
        || (isAtEnd && (vertexRows.contains(row - 1) || vertexRows.contains(row + 1)));
}

/// Whether the spans are steps that a decision parameter leads: p_k, or those of an outline's
/// pixels.
bool hasDecisions(const ScanTrace &trace)
{
    const auto &numbers = trace.numbers().span;
    return hasNumber(numbers, "p_k") || hasNumber(numbers, "p_low");
}

/// The first and last span of each part, those at vertices, and the spans with a tie.
void appendSpanMarks(std::vector<TraceMark> &marks, const TracedScene &traced,
                     std::size_t primitive)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t first = trace.firstSpanOf(primitive);
    const std::size_t end = trace.endSpanOf(primitive);
    if (first == end)
        return;
    const bool isTriangle = traced.primitives.isTriangle(primitive);
    // Steps along a line or an outline tell by themselves whether they pass between two pixels.
    const bool isStepped
        = traced.primitives.kindOf(primitive) == PrimitiveKind::Line || hasDecisions(trace);
    const bool isPolygon
        = !isStepped && traced.primitives.kindOf(primitive) == PrimitiveKind::Polygon;
    std::set<std::int64_t> tieRows, vertexRows;
    if (isPolygon) {
        tieRows = tieRowsOf(traced.primitives.shape(primitive), traced.scene.frame);
        vertexRows = vertexRowsOf(traced.primitives.shape(primitive));
    }
    // A polygon is walked as one part, or in as many as it has triangles.
    const bool isWhole = isPolygon && trace.placeOf(first).axis == SpanAxis::Row
        && trace.placeOf(first).part == trace.placeOf(end - 1).part;
    const Triangle upright = isTriangle ? traced.primitives.triangles[primitive] : Triangle();
    const Triangle lying = mirrored(upright);
    std::vector<std::size_t> ends; // of parts, and at vertices
    int part = trace.placeOf(first).part;
    for (std::size_t span = first; span < end; ++span) {
        const SpanPlace &place = trace.placeOf(span);
        const bool isAtEnd = span == first || place.part != part || span + 1 == end;
        if (isWhole ? isNextTo(vertexRows, place.coordinate, isAtEnd)
                    : isAtEnd && (!isTriangle || isAtVertex(upright, place))) {
            marks.push_back({trace.indexOfSpan(span), MarkKind::PartBegins});
            ends.push_back(span);
        }
        part = place.part;
        const auto hasTie = [&] {
            if (isStepped)
                return trace.span(span).isTie;
            if (place.axis == SpanAxis::Row && tieRows.contains(place.coordinate))
                return true;
            return isTriangle && place.axis != SpanAxis::Free
                && oracle::hasTie(place.axis == SpanAxis::Column ? upright : lying,
                                  place.coordinate);
        };
        if (hasTie())
            marks.push_back({trace.indexOfSpan(span), MarkKind::Tie});
    }
    if (isTriangle)
        appendVerticesWithinParts(marks, trace, upright, primitive, ends);
}

} // namespace

std::vector<TraceMark> marksOf(const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    std::vector<TraceMark> marks;
    for (std::size_t primitive = 0; primitive < trace.primitiveCount(); ++primitive)
        appendSpanMarks(marks, traced, primitive);
    std::optional<std::size_t> lastClampSpan;
    for (const std::size_t sample : trace.clampedSamples()) {
        const std::size_t span = trace.spanOf(sample);
        if (lastClampSpan != span)
            marks.push_back({trace.indexOfSample(sample), MarkKind::Clamp});
        lastClampSpan = span;
    }
    if (const auto wrong = traced.firstWrongPixel(); wrong && wrong->decidedAt > 0)
        marks.push_back({wrong->decidedAt - 1, MarkKind::FirstDifference});
    std::ranges::stable_sort(marks, {}, &TraceMark::step);
    return marks;
}

} // namespace pixelplumb
