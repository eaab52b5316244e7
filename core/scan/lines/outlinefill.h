// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/lines/linebresenham.h"
#include "core/scan/walks/columnscan.h"

#include <optional>

/// "Use Midpoint Algorithm for edges and fill in?" (Triangles slides): the three edges as lines of
/// whole pixels, by the midpoint algorithm, which is Bresenham's, and each column filled from the
/// outline's lowest pixel to its highest. These two have the colours of their lines; between them
/// colours change evenly. An outline pixel is the nearest to an edge, on whichever side: the
/// picture is not the truth, and two triangles that share an edge both paint it.
namespace pixelplumb {

/// One edge of the outline, walked from its left end, a steep one from its lower end.
struct OutlineEdge {
    BresenhamSetUp line;
    std::array<std::size_t, 2> ends = {}; ///< indices of its two corners
};

struct OutlineFillSetUp {
    std::array<Vertex, 3> corners; ///< on whole pixels, in the caller's order
    std::array<OutlineEdge, 3> edges; ///< P₀P₁, P₁P₂, P₂P₀
};

/// A pixel of the outline in the current column.
struct OutlinePixel {
    std::int64_t row = 0; ///< px
    std::size_t edge = 0;
    std::int64_t number = 0; ///< along the edge, from 0
};

template <class A>
struct OutlineFillSpan {
    OutlinePixel low, high;
    ColumnState<A> column; ///< from low to high
};

template <class A>
struct OutlineFillNumbers {
    using SetUp = OutlineFillSetUp;
    using Span = OutlineFillSpan<A>;
    using Sample = Fragment<A>;
};

inline OutlineFillSetUp outlineFillSetUp(const Triangle &triangle)
{
    OutlineFillSetUp setUp;
    for (std::size_t corner = 0; corner < 3; ++corner)
        setUp.corners[corner] = onPixel(triangle.vertices[corner]);
    const auto pixelOf = [](const Vertex &vertex) {
        return LatticePoint{floorPixel(vertex.position.x), floorPixel(vertex.position.y)};
    };
    for (std::size_t edge = 0; edge < 3; ++edge) {
        std::array<std::size_t, 2> ends = {edge, (edge + 1) % 3};
        const auto end = [&](std::size_t i) { return setUp.corners[ends[i]]; };
        const LineAxis axis = lineAxisOf(end(0).position, end(1).position);
        if (exchanged(end(1), axis).position.x < exchanged(end(0), axis).position.x)
            std::swap(ends[0], ends[1]);
        setUp.edges[edge] = {bresenhamSetUp(pixelOf(end(0)), pixelOf(end(1))), ends};
    }
    return setUp;
}

/// The pixels of a line in a column, by their numbers, found without stepping through those before.
/// After n pixels a line has gone ⌊n·Δy/Δx + 1/2⌋ across.
inline StepRange outlinePixelsIn(const BresenhamSetUp &line, std::int64_t column)
{
    const StepRange whole = {0, line.deltaX + 1};
    if (line.axis == LineAxis::X)
        return StepRange{column - line.start.x, column - line.start.x + 1}.clippedTo(whole);
    const Int128 across = Int128(column - line.start.y) * line.acrossStep;
    if (across < 0 || across > line.deltaY)
        return {};
    if (line.deltaY == 0)
        return whole;
    const auto firstAt = [&](const Int128 &doubled) {
        return std::int64_t(-floorDivide<Int128>(-doubled * line.deltaX, 2 * Int128(line.deltaY)));
    };
    return StepRange{firstAt(2 * across - 1), firstAt(2 * across + 1)}.clippedTo(whole);
}

/// The lowest and the highest pixel of the outline in a column; if several edges share the row, the
/// first edge's. None where the outline does not reach the column.
inline std::optional<std::array<OutlinePixel, 2>> outlineIn(const OutlineFillSetUp &setUp,
                                                            std::int64_t column)
{
    std::optional<std::array<OutlinePixel, 2>> found;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const BresenhamSetUp &line = setUp.edges[edge].line;
        const StepRange pixels = outlinePixelsIn(line, column);
        if (pixels.isEmpty())
            continue;
        for (const std::int64_t number : {pixels.first, pixels.end - 1}) {
            const OutlinePixel pixel = {bresenhamStepAt(line, number).place.y(), edge, number};
            if (!found)
                found = {pixel, pixel};
            if (pixel.row < (*found)[0].row)
                (*found)[0] = pixel;
            if (pixel.row > (*found)[1].row)
                (*found)[1] = pixel;
        }
    }
    return found;
}

/// The colours of a column between two pixels of the outline, all over the product of the edges'
/// lengths and the column's height, so that adding needs no division: below 2^102.
template <class A>
void setColours(const OutlineFillSetUp &setUp, OutlineFillSpan<A> &span)
{
    using Number = typename A::Number;
    using Integer = std::decay_t<decltype(Number().denominator)>;
    const auto lengthOf = [&](const OutlinePixel &pixel) -> Integer {
        return std::max<std::int64_t>(1, setUp.edges[pixel.edge].line.deltaX);
    };
    /// The numerator over the edge's length.
    const auto levelAt = [&](const OutlinePixel &pixel, std::size_t channel) -> Integer {
        const auto &ends = setUp.edges[pixel.edge].ends;
        const Integer from = setUp.corners[ends[0]].colour.channels[channel];
        const Integer to = setUp.corners[ends[1]].colour.channels[channel];
        return from * lengthOf(pixel) + Integer(pixel.number) * (to - from);
    };
    const Integer height = span.high.row - span.low.row;
    const Integer lowLength = lengthOf(span.low);
    const Integer highLength = lengthOf(span.high);
    const Integer up = span.column.firstDrawn - span.low.row;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Integer low = levelAt(span.low, channel);
        const Integer high = levelAt(span.high, channel);
        span.column.colourBottom[channel] = Number::fromFraction(low, lowLength);
        span.column.colourTop[channel] = Number::fromFraction(high, highLength);
        if (height == Integer(0)) {
            span.column.firstColour[channel] = span.column.colourBottom[channel];
            span.column.colourRate[channel] = Number::fromFraction(0, lowLength);
            continue;
        }
        const Integer whole = lowLength * highLength * height;
        const Integer rise = high * lowLength - low * highLength;
        span.column.firstColour[channel]
            = Number::fromFraction(low * highLength * height + up * rise, whole);
        span.column.colourRate[channel] = Number::fromFraction(rise, whole);
    }
}

template <class A, ScanObserver<OutlineFillNumbers<A>> Observer>
void fillOutline(const Triangle &triangle, ByteRounding rounding, FrameView frame,
                 Observer observer)
{
    const OutlineFillSetUp setUp = outlineFillSetUp(triangle);
    observer.primitiveBegun(setUp);
    const auto [left, right] = std::minmax({floorPixel(setUp.corners[0].position.x),
                                            floorPixel(setUp.corners[1].position.x),
                                            floorPixel(setUp.corners[2].position.x)});
    const auto [low, high] = std::minmax({floorPixel(setUp.corners[0].position.y),
                                          floorPixel(setUp.corners[1].position.y),
                                          floorPixel(setUp.corners[2].position.y)});
    const StepRange columns
        = StepRange{left, right + 1}.clippedTo(StepRange::along(frame, LineAxis::X));
    if (columns.isEmpty() || low >= frame.endRow() || high < frame.firstRow) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        const auto outline = outlineIn(setUp, x);
        if (!outline)
            continue;
        OutlineFillSpan<A> span{(*outline)[0], (*outline)[1], {}};
        ColumnState<A> &column = span.column;
        column.x = x;
        column.yBottom = A::Number::fromWhole(span.low.row);
        column.yTop = A::Number::fromWhole(span.high.row);
        column.firstRow = span.low.row;
        column.endRow = span.high.row + 1;
        column.firstDrawn = std::max<std::int64_t>(column.firstRow, frame.firstRow);
        column.endDrawn = std::min(column.endRow, frame.endRow());
        setColours(setUp, span);
        observer.spanEntered(span);
        fillColumn(column, rounding, frame, observer);
    }
}

} // namespace pixelplumb
