// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/framereach.h"

#include <cmath>

namespace pixelplumb {

namespace {

std::int64_t sizeOf(const SampleBox &box)
{
    return box.isEmpty() ? 0 : (box.endX - box.firstX) * (box.endY - box.firstY);
}

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

SampleBox reachOf(const Triangle &triangle, const FrameView &frame, Antialiasing antialiasing)
{
    if (antialiasing == Antialiasing::None)
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

} // namespace pixelplumb
