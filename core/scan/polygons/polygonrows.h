// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/polygons/contours.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interval.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

#include <memory>
#include <vector>

/// The numbers of the general scan conversion of polygons (Scan Conversion slides, "Scan
/// Conversion: A General Algorithm").
namespace pixelplumb {

/// The rows that an edge crosses from its lower end's y to its upper end's, with samples displaced
/// down on the screen.
constexpr Interval rowsCrossed(FrameOrigin origin)
{
    return origin == FrameOrigin::TopLeft ? Interval::ClosedOpen : Interval::OpenClosed;
}

/// What an edge adds to the winding number of the samples to its right: +1 where its contour runs
/// downward on the screen, −1 where it runs upward, so that a contour that turns counter-clockwise
/// on the screen has +1 inside. Not for horizontal edges, which no row crosses.
constexpr int windingRightOf(const ContourEdge &edge, FrameOrigin origin)
{
    const bool isDownward = (edge.to.y < edge.from.y) == (origin == FrameOrigin::BottomLeft);
    return isDownward ? 1 : -1;
}

/// What is computed once for a polygon.
struct PolygonSetUp {
    std::size_t contourCount = 0;
    std::size_t edgeCount = 0;
    std::size_t horizontalEdges = 0; ///< no row crosses them
    std::size_t pieceCount = 0; ///< triangles, where the polygon is broken into them
    std::size_t crossingCount = 0; ///< corners of triangles where edges cross
    double largestMove = 0; ///< the farthest move of such a corner onto the lattice, px
    std::size_t curveCount = 0; ///< Bézier pieces, where the edges are their chords
    std::int64_t firstRow = 0, endRow = 0; ///< that the polygon's edges cross, unclipped
    FrameOrigin origin = FrameOrigin::BottomLeft; ///< of the frame: which way is down on the screen
    ShapeFill fill = ShapeFill::EvenOdd;
    Colour colour;
    /// The edges that crossings refer to, three of each triangle where the polygon is broken into
    /// them; only for observers that read numbers.
    std::shared_ptr<const std::vector<ContourEdge>> edges = nullptr;
};

/// An active edge where it meets the row.
template <class A>
struct Crossing {
    using Number = typename A::Number;

    std::size_t edge = 0; ///< its index in the contours, from 0
    int turn = 0; ///< windingRightOf()
    std::int64_t endRow = 0; ///< one past the last row that the edge crosses
    Number slope = {}; ///< px per row
    Number base = {}; ///< x at the lower end, then x on the previous row
    Number rise = {}; ///< rows from base to this row: a pre-step, then 1
    Number x = {}; ///< base + rise · slope, px
    NarrowBeside<Number> firstRight
        = 0; ///< ⌈x⌉: the first sample to the right of the edge, or on it
};

/// One row: its crossings from left to right.
template <class A>
struct PolygonRow {
    std::int64_t y = 0; ///< px
    int piece = 0; ///< index of the triangle, where the polygon is broken into them
    std::vector<Crossing<A>> crossings; ///< of all active edges, ascending in x
    std::int64_t firstSample = 0, endSample = 0; ///< ⌈x⌉ of the first and of the last crossing
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< the same, clipped to the frame
};

/// Why a sample is in or out.
struct PolygonSample {
    std::int64_t crossings = 0; ///< to its left, or through it
    std::int64_t winding = 0; ///< downward ones minus upward ones, on the screen
    Colour colour;
};

template <class A>
struct PolygonNumbers {
    using SetUp = PolygonSetUp;
    using Span = PolygonRow<A>;
    using Sample = PolygonSample;
};

/// Fills the samples from a row's first crossing to its last, left to right: inside by the parity
/// of the crossings so far, or by their winding number. It reads only the row and the set-up, so
/// that a row can be drawn again, alone.
template <class A, class Observer>
void fillRow(const PolygonRow<A> &row, const PolygonSetUp &setUp, FrameView frame,
             Observer observer)
{
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    PolygonSample sample;
    sample.colour = setUp.colour;
    auto next = row.crossings.begin();
    for (std::int64_t x = row.firstDrawn; x < row.endDrawn; ++x) {
        for (; next != row.crossings.end() && next->firstRight <= x; ++next) {
            ++sample.crossings;
            sample.winding += next->turn;
        }
        QRgb *pixel = frame.at(x, row.y);
        const bool isInside
            = setUp.fill == ShapeFill::NonZero ? sample.winding != 0 : sample.crossings % 2 != 0;
        if (!isInside) {
            observer.sampleRejected(x, row.y, *pixel, sample);
            continue;
        }
        const QRgb after = packed(setUp.colour);
        observer.pixelWritten(x, row.y, *pixel, after, sample);
        *pixel = after;
    }
}

} // namespace pixelplumb
