// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/polygons/polygonedges.h"

/// General scan conversion (Scan Conversion slides, "Scan Conversion: A General Algorithm"):
/// intersect each row with all edges, sort the intersections in x, and fill where their parity is
/// odd (or the winding number is not zero). Row-to-row coherence: edges wait in a table until their
/// first row, and an active edge moves by adding its slope.
namespace pixelplumb {

/// A polygon's set-up, before its rows are walked.
inline PolygonSetUp polygonSetUpFor(const Contours &contours, FrameOrigin origin)
{
    PolygonSetUp setUp;
    setUp.contourCount = contours.count;
    setUp.edgeCount = contours.edges.size();
    setUp.curveCount = contours.curveCount;
    setUp.origin = origin;
    setUp.fill = contours.fill;
    setUp.colour = contours.colour;
    for (const ContourEdge &edge : contours.edges)
        setUp.horizontalEdges += std::size_t(edge.from.y == edge.to.y);
    const ContourBox box = boxAround(contours.edges);
    setUp.firstRow = firstSampleFrom(box.first.y, rowsCrossed(origin));
    setUp.endRow = endSampleAt(box.last.y, rowsCrossed(origin));
    return setUp;
}

/// Why nothing of a polygon can be drawn, before any row is entered.
template <class A>
std::optional<PrimitiveRejection> polygonRejection(const Contours &contours, const FrameView &frame)
{
    for (const ContourEdge &edge : contours.edges) {
        if (!A::represents(edge.from))
            return PrimitiveRejection::NotRepresentable;
    }
    const ContourBox box = boxAround(contours.edges);
    if (box.isFlat())
        return PrimitiveRejection::ZeroArea;
    if (ceilPixel(box.first.x) >= frame.endColumn() || floorPixel(box.last.x) < frame.firstColumn
        || ceilPixel(box.first.y) >= frame.endRow() || floorPixel(box.last.y) < frame.firstRow)
        return PrimitiveRejection::OutsideFrame;
    return std::nullopt;
}

/// Walks the rows that the edges cross, from low to high.
template <class A, ScanObserver<PolygonNumbers<A>> Observer>
void scanRows(std::span<const ContourEdge> edges, const PolygonSetUp &setUp, int piece,
              FrameView frame, Observer observer)
{
    EdgeTable<A> table(edges, frame.origin);
    ActiveEdges<A> active;
    if (table.size() == 0)
        return;
    const std::int64_t first = std::max<std::int64_t>(table.firstRow(), frame.firstRow);
    const std::int64_t end
        = std::min(endSampleAt(boxAround(edges).last.y, rowsCrossed(frame.origin)), frame.endRow());
    PolygonRow<A> row;
    row.piece = piece;
    for (row.y = first; row.y < end; ++row.y) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        active.enterRow(row.y, table);
        if (active.crossings().empty())
            continue; // between two contours
        row.crossings = active.crossings();
        row.firstSample = std::int64_t(row.crossings.front().firstRight);
        row.endSample = std::int64_t(row.crossings.back().firstRight);
        row.firstDrawn = std::max<std::int64_t>(row.firstSample, frame.firstColumn);
        row.endDrawn = std::min(row.endSample, frame.endColumn());
        observer.spanEntered(row);
        fillRow(row, setUp, frame, observer);
        active.leaveRow(row.y);
    }
}

/// Scans one polygon into one frame. `edges`: the contours', where the run may share them, else it
/// keeps a copy.
template <class A, ScanObserver<PolygonNumbers<A>> Observer>
void scanPolygon(const Contours &contours, FrameView frame, Observer observer,
                 const std::shared_ptr<const std::vector<ContourEdge>> &edges = nullptr)
{
    PolygonSetUp setUp = polygonSetUpFor(contours, frame.origin);
    if constexpr (readsNumbers<Observer>)
        setUp.edges
            = edges ? edges : std::make_shared<const std::vector<ContourEdge>>(contours.edges);
    observer.primitiveBegun(setUp);
    if (const auto rejection = polygonRejection<A>(contours, frame)) {
        observer.primitiveRejected(*rejection);
        return;
    }
    scanRows<A>(contours.edges, setUp, 0, frame, observer);
}

} // namespace pixelplumb
