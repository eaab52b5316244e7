// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/interval.h"
#include "core/scan/mistakes/variededge.h"
#include "core/scan/scansettings.h"

/// What is walked, and from which end.
namespace pixelplumb {

/// The end from which a triangle's spans are visited; a right program draws the same either way.
enum class SpanOrder { Ascending, Descending };

/// R G B of a sample, rounded but not clamped.
using WholeLevels = std::array<std::int64_t, 3>;

/// A triangle as it is walked: x is the coordinate that counts spans.
struct WalkedTriangle {
    Triangle triangle;
    SpanOrder order = SpanOrder::Ascending; ///< the method's
    ScanIntervals intervals; ///< of its spans, ascending, and of its samples
    ScanSettings settings;
    std::int64_t firstSpan = 0, endSpan = 0; ///< in the frame
    std::int64_t firstSample = 0, endSample = 0; ///< in the frame, of a span
};

/// An interval seen from its other end.
constexpr Interval reversed(Interval interval)
{
    if (interval == Interval::ClosedOpen)
        return Interval::OpenClosed;
    return interval == Interval::OpenClosed ? Interval::ClosedOpen : interval;
}

/// The triangle as seen by a program that visits spans in ascending order.
inline WalkedTriangle seenFrom(WalkedTriangle triangle, SpanOrder order)
{
    if (order == SpanOrder::Ascending)
        return triangle;
    for (Vertex &vertex : triangle.triangle.vertices)
        vertex.position.x = -vertex.position.x;
    const std::int64_t first = triangle.firstSpan;
    triangle.firstSpan = 1 - triangle.endSpan;
    triangle.endSpan = 1 - first;
    triangle.intervals.columns = reversed(triangle.intervals.columns);
    return triangle;
}

/// The end from which the program goes.
inline SpanOrder orderOf(const ScanBugs &bugs, SpanOrder ofMethod)
{
    if (bugs.order == WalkOrder::OfMethod)
        return ofMethod;
    return bugs.order == WalkOrder::Ascending ? SpanOrder::Ascending : SpanOrder::Descending;
}

/// From the other end, a program does not share the method's variants along edges.
inline VariantSet variantsFrom(SpanOrder order, const WalkedTriangle &triangle)
{
    VariantSet variants = triangle.settings.variants;
    for (const Variant variant : variantsAlongEdges) {
        if (order != triangle.order)
            variants = variants.without(variant);
    }
    return variants;
}

} // namespace pixelplumb
