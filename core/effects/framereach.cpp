// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/framereach.h"

#include "core/effects/strokestrip.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

std::int64_t sizeOf(const SampleBox &box)
{
    return box.isEmpty() ? 0 : (box.endX - box.firstX) * (box.endY - box.firstY);
}

/// The closed squares of a frame's pixels together; units of so many a pixel.
struct FrameSquare {
    FrameSquare(const FrameView &frame, std::int64_t unitsOfPixel)
        : pixel(unitsOfPixel)
        , left(frame.firstColumn * pixel - pixel / 2)
        , right(frame.endColumn() * pixel - pixel / 2)
        , low(frame.firstRow * pixel - pixel / 2)
        , high(frame.endRow() * pixel - pixel / 2)
    {
    }

    /// Whether a segment meets it; `isOpen`: its interior, and not only along borders of pixels.
    template <class Point>
    bool isMetBy(const Point &a, const Point &b, bool isOpen) const
    {
        const auto isBorder = [this](std::int64_t at) { return (at - pixel / 2) % pixel == 0; };
        if (isOpen && ((a.x == b.x && isBorder(a.x)) || (a.y == b.y && isBorder(a.y))))
            return false;
        const auto isBeside = [isOpen](std::int64_t most, std::int64_t from) {
            return isOpen ? most <= from : most < from;
        };
        if (isBeside(std::max(a.x, b.x), left) || isBeside(right, std::min(a.x, b.x))
            || isBeside(std::max(a.y, b.y), low) || isBeside(high, std::min(a.y, b.y)))
            return false;
        // Apart, else, only where the line has all four corners on one side.
        Int128 least = 0, most = 0;
        bool isFirst = true;
        for (const std::int64_t x : {left, right}) {
            for (const std::int64_t y : {low, high}) {
                const Int128 side = Int128(b.x - a.x) * (y - a.y) - Int128(x - a.x) * (b.y - a.y);
                least = isFirst ? side : std::min(least, side);
                most = isFirst ? side : std::max(most, side);
                isFirst = false;
            }
        }
        return isOpen ? least < 0 && most > 0 : least <= 0 && most >= 0;
    }

    std::int64_t pixel, left, right, low, high;
};

/// Calls `visit` with the absolute differences of x and y along each edge, px.
template <class Visit>
void forEachEdge(const Triangle &triangle, const Visit &visit)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &a = triangle.vertices[i].position;
        const LatticePoint &b = triangle.vertices[(i + 1) % 3].position;
        visit(double(absolute(b.x - a.x)) / double(unitsPerPixel),
              double(absolute(b.y - a.y)) / double(unitsPerPixel));
    }
}

} // namespace

SampleBox reachOf(const Triangle &triangle, const SampledFrame &where)
{
    const FrameView &frame = where.frame;
    if (doubledArea(triangle) == 0 && where.rule != FillRule::Closed)
        return {};
    if (where.antialiasingOf(triangle) == Antialiasing::None)
        return intersection(boundingBoxOf(triangle), samplesOf(frame));
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    const SampleBox squares{ceilPixel(left - halfPixel), floorPixel(right + halfPixel) + 1,
                            ceilPixel(low - halfPixel), floorPixel(high + halfPixel) + 1};
    return intersection(squares, samplesOf(frame));
}

std::int64_t mostPixelsOf(const Triangle &triangle, const SampleBox &reach,
                          Antialiasing antialiasing)
{
    const std::int64_t inBox = sizeOf(reach);
    constexpr std::int64_t fewPixels = 4;
    if (inBox <= fewPixels)
        return inBox;
    double perimeter = 0;
    double boxPerimeter = 0; // each side of the box is passed there and back
    forEachEdge(triangle, [&](double x, double y) {
        perimeter += std::sqrt(x * x + y * y);
        boxPerimeter += x + y;
    });
    double area = double(absolute(doubledArea(triangle))) / (2 * double(unitsPerPixel))
        / double(unitsPerPixel);
    if (antialiasing != Antialiasing::None) {
        area += boxPerimeter / 2 + 1; // by the square, its width and its height
        perimeter += 4;
    }
    constexpr double aboveRounding = 1 + 0x1p-40;
    return std::min(inBox, std::int64_t((area + perimeter / 2 + 1) * aboveRounding));
}

std::int64_t mostPixelsOf(const Shape &stroke, const FrameView &frame)
{
    const std::int64_t inFrame = std::int64_t(frame.width) * frame.height;
    if (stroke.kind != PrimitiveKind::Line)
        return inFrame;
    const LatticePoint &a = stroke.vertices[0].position;
    const LatticePoint &b = stroke.vertices[1].position;
    const double width = double(absolute(b.x - a.x)) / double(unitsPerPixel);
    const double height = double(absolute(b.y - a.y)) / double(unitsPerPixel);
    const double area = 2 * (width + height) + 4;
    const double perimeter = 2 * std::hypot(width, height) + 8;
    return std::min(inFrame, std::int64_t(std::ceil(area + perimeter / 2 + 1)));
}

std::int64_t mostEdgePixelsOf(const Triangle &triangle, const SampleBox &reach)
{
    // Along a border between squares it meets those of both sides, and at a corner all four.
    double pixels = 0;
    forEachEdge(triangle, [&](double x, double y) { pixels += std::ceil(2 * (x + y)) + 4; });
    return std::min(sizeOf(reach), std::int64_t(pixels));
}

bool hasEdgePixels(const Triangle &triangle, const SampledFrame &where)
{
    if (where.antialiasingOf(triangle) == Antialiasing::None)
        return false;
    const FrameSquare square(where.frame, unitsPerPixel);
    const bool isOpen = where.antialiasing == Antialiasing::Area;
    for (std::size_t i = 0; i < 3; ++i) {
        if (square.isMetBy(triangle.vertices[i].position, triangle.vertices[(i + 1) % 3].position,
                           isOpen))
            return true;
    }
    return false;
}

bool hasEdgePixels(const Shape &stroke, const SampledFrame &where)
{
    if (where.antialiasing == Antialiasing::None || stroke.vertices.empty() || !isStroke(stroke))
        return false;
    const FrameSquare square(where.frame, strokeUnitsPerPixel);
    const bool isOpen = where.antialiasing == Antialiasing::Area;
    const StrokeStrip strip = strokeStripOf(stroke, where.frame);
    return std::ranges::any_of(strip.quads, [&](const StrokeQuad &quad) {
        for (std::size_t i = 0; i < quad.size(); ++i) {
            if (square.isMetBy(quad[i], quad[(i + 1) % quad.size()], isOpen))
                return true;
        }
        return false;
    });
}

} // namespace pixelplumb
