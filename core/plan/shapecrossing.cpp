// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/bordercrossing.h"
#include "core/shade/edgepixels.h"
#include "core/shade/strokes/strokearea.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether an antialiased line or curve covers a sample of the frame or, with area antialiasing, a
/// part of one of its pixels.
bool isDrawn(const StrokeStrip &strip, const SampledFrame &where)
{
    const std::vector<StrokePixel> pixels = strokePixels(strip.quads, where.frame);
    const std::span<const LatticePoint> pattern = samplePattern(where.antialiasing);
    for (auto pixel = pixels.begin(); pixel != pixels.end();) {
        const auto next = std::find_if(pixel, pixels.end(), [&](const StrokePixel &other) {
            return other.x != pixel->x || other.y != pixel->y;
        });
        const StrokeCoverage coverage(std::span(pixel, next), strip.quads);
        const auto isCovered = [&](const LatticePoint &sample) { return coverage.covers(sample); };
        if (pattern.empty() ? !coverage.share().isEmpty : std::ranges::any_of(pattern, isCovered))
            return true;
        pixel = next;
    }
    return false;
}

/// The pixels of an antialiased line, which ends where its segment ends.
SampleBox boxOfLine(const StrokeStrip &strip)
{
    if (strip.quads.empty())
        return {};
    const auto byX = std::ranges::minmax(strip.quads.front(), {}, &StrokePoint::x);
    const auto byY = std::ranges::minmax(strip.quads.front(), {}, &StrokePoint::y);
    const auto first = [](StrokeUnit low) {
        return floorDivide<StrokeUnit>(low + strokeHalfPixel, strokeUnitsPerPixel);
    };
    const auto end = [](StrokeUnit high) {
        return ceilDivide<StrokeUnit>(high + strokeHalfPixel, strokeUnitsPerPixel);
    };
    return {first(byX.min.x), end(byX.max.x), first(byY.min.y), end(byY.max.y)};
}

/// All pixels that the shape may have, from its vertices. An antialiased curve extends ½ px to each
/// side; other shapes reach the pixels that their ends are rounded to, and a circle's radius too. A
/// text, whose length depends on its font, gets a generous box.
SampleBox boxAround(const Shape &shape, Antialiasing antialiasing)
{
    Lattice left = largestCoordinate, right = -largestCoordinate;
    Lattice low = largestCoordinate, high = -largestCoordinate;
    const auto take = [&](Lattice x, Lattice y) {
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
    };
    for (const Vertex &vertex : shape.vertices)
        take(vertex.position.x, vertex.position.y);
    const bool isRound
        = shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse;
    if (isRound && shape.vertices.size() == 2) {
        const LatticePoint &centre = shape.vertices[0].position;
        const LatticePoint &corner = shape.vertices[1].position;
        take(2 * centre.x - corner.x, 2 * centre.y - corner.y);
    }
    if (shape.kind == PrimitiveKind::Text) {
        const Lattice height = 2 * absolute(shape.textHeight);
        const Lattice length = height * Lattice(shape.text.size());
        take(left - height, low - height);
        take(right + length, high + height);
    }
    if (shape.kind == PrimitiveKind::Text || antialiasing != Antialiasing::None)
        return {floorPixel(left), ceilPixel(right) + 1, floorPixel(low), ceilPixel(high) + 1};
    const Lattice beside = isRound ? 2 * halfPixel : halfPixel;
    return {ceilPixel(left - beside), floorPixel(right + beside) + 1, ceilPixel(low - beside),
            floorPixel(high + beside) + 1};
}

/// Whether a line, points or an outline has one vertex whose pixel is in the frame and one whose
/// pixel is not, however halves are rounded. A stroke's end counts as outside only a pixel further.
bool crossesByVertices(const Shape &shape, const FrameView &frame, Antialiasing antialiasing)
{
    const bool isOutlined = shape.kind == PrimitiveKind::Line || shape.kind == PrimitiveKind::Point
        || (shape.kind == PrimitiveKind::Polygon && shape.fill == ShapeFill::Outline);
    const auto crossing = [&frame](const Vertex &vertex, Lattice around) {
        const LatticePoint &at = vertex.position;
        return crossingOfBox({ceilPixel(at.x - around), floorPixel(at.x + around) + 1,
                              ceilPixel(at.y - around), floorPixel(at.y + around) + 1},
                             frame);
    };
    const auto isIn = [&](const Vertex &vertex) {
        return crossing(vertex, halfPixel) == BorderCrossing::Within;
    };
    const auto isBeyond = [&](const Vertex &vertex) {
        return crossing(vertex, antialiasing == Antialiasing::None ? halfPixel : 2 * halfPixel)
            == BorderCrossing::Outside;
    };
    return isOutlined && std::ranges::any_of(shape.vertices, isIn)
        && std::ranges::any_of(shape.vertices, isBeyond);
}

/// Whether each point, each contour of a polygon or each piece of a curve has a box of its own that
/// holds nothing of the frame.
bool isOutsideInParts(const Shape &shape, const FrameView &frame, Antialiasing antialiasing)
{
    std::vector<std::size_t> ends = shape.laterContours;
    if (shape.kind == PrimitiveKind::Point) {
        for (std::size_t end = 1; end < shape.vertices.size(); ++end)
            ends.push_back(end);
    }
    ends.push_back(shape.vertices.size());
    Shape part;
    part.kind = shape.kind;
    std::size_t first = 0;
    return std::ranges::all_of(ends, [&](std::size_t end) {
        const auto vertices = std::span(shape.vertices).subspan(first, end - first);
        part.vertices.assign(vertices.begin(), vertices.end());
        first = end;
        return crossingOfBox(boxAround(part, antialiasing), frame) == BorderCrossing::Outside;
    });
}

/// Whether a line misses all pixels of the frame: at the frame's sample columns (rows where it is
/// steep) it is more than half a pixel beyond its rows (columns).
bool passesBy(const Shape &line, const FrameView &frame)
{
    const LatticePoint &a = line.vertices.front().position;
    const LatticePoint &b = line.vertices.back().position;
    const bool isSteep = absolute(b.y - a.y) >= absolute(b.x - a.x);
    const Lattice besideX = isSteep ? halfPixel : 0;
    const Lattice besideY = isSteep ? 0 : halfPixel;
    const LatticePoint low = latticePixel(frame.firstColumn, frame.firstRow);
    const LatticePoint high = latticePixel(frame.endColumn() - 1, frame.endRow() - 1);
    int above = 0, below = 0; // corners on each side of the line
    for (const Lattice x : {low.x - besideX, high.x + besideX}) {
        for (const Lattice y : {low.y - besideY, high.y + besideY}) {
            const Int128 side = doubledArea(a, b, {x, y});
            above += side > 0 ? 1 : 0;
            below += side < 0 ? 1 : 0;
        }
    }
    return above == 4 || below == 4;
}

} // namespace

BorderCrossing borderCrossingOf(const Shape &shape, const SampledFrame &where)
{
    if (shape.vertices.empty())
        return BorderCrossing::Outside;
    const FrameView &frame = where.frame;
    const bool isLine = shape.kind == PrimitiveKind::Line;
    const bool isAntialiased = where.antialiasing != Antialiasing::None && isStroke(shape);
    const Antialiasing antialiasing = isAntialiased ? where.antialiasing : Antialiasing::None;
    if (isAntialiased && isShort(shape) && !isDrawn(strokeStripOf(shape, frame), where))
        return BorderCrossing::Outside;
    const BorderCrossing crossing
        = crossingOfBox(isAntialiased && isLine ? boxOfLine(strokeStripOf(shape, frame))
                                                : boxAround(shape, antialiasing),
                        frame);
    if (crossing != BorderCrossing::MayCross || shape.kind == PrimitiveKind::Text)
        return crossing;
    if (isOutsideInParts(shape, frame, antialiasing))
        return BorderCrossing::Outside;
    if (isLine && shape.vertices.size() == 2 && where.antialiasing == Antialiasing::None
        && passesBy(shape, frame))
        return BorderCrossing::Outside;
    if (isAntialiased && !isDrawn(strokeStripOf(shape, frame), where))
        return BorderCrossing::Outside;
    return crossesByVertices(shape, frame, antialiasing) ? BorderCrossing::Crosses
                                                         : BorderCrossing::MayCross;
}

bool callsForAntialiasing(const Shape &stroke, const SampledFrame &where)
{
    if (!hasEdgePixels(stroke, where))
        return false;
    SampledFrame plain = where;
    plain.antialiasing = Antialiasing::None;
    return borderCrossingOf(stroke, where) != BorderCrossing::Outside
        || borderCrossingOf(stroke, plain) != BorderCrossing::Outside;
}

} // namespace pixelplumb
