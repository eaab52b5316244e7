// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/framereach.h"

#include "core/plan/drawnplane.h"
#include "core/plan/framesquare.h"
#include "core/shade/edgepixels.h"
#include "core/shade/strokes/strokearea.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>
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

/// Whether the sample nearest to the triangle's middle lies inside it: true for most triangles.
bool coversItsMiddle(const Triangle &triangle, const SampleBox &box)
{
    const auto middleOf = [&](Lattice LatticePoint::*along, std::int64_t first, std::int64_t end) {
        const auto &v = triangle.vertices;
        const Lattice sum = v[0].position.*along + v[1].position.*along + v[2].position.*along;
        return std::clamp(std::int64_t(floorPixel(sum / 3 + halfPixel)), first, end - 1);
    };
    const LatticePoint middle = latticePixel(middleOf(&LatticePoint::x, box.firstX, box.endX),
                                             middleOf(&LatticePoint::y, box.firstY, box.endY));
    int left = 0, right = 0; // number of edges
    for (std::size_t i = 0; i < 3; ++i) {
        const Int128 side = doubledArea(triangle.vertices[i].position,
                                        triangle.vertices[(i + 1) % 3].position, middle);
        left += side > 0 ? 1 : 0;
        right += side < 0 ? 1 : 0;
    }
    return left == 3 || right == 3;
}

/// Whether it is drawn at some sample of these pixels or, with area antialiasing, covers a part of
/// one.
bool isDrawnIn(const SampleBox &box, const Triangle &triangle, const SampledFrame &where,
               const std::array<Attribute, 3> &horizon)
{
    const auto isDrawnAs = [&](const LatticePoint &sample) {
        if (coversItsMiddle(seenFrom(triangle, sample), box))
            return true;
        const DrawnPlane plane({&triangle, {}, horizon}, sample, where);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            RowPixels columns = {box.firstX, box.endX};
            plane.keepDrawn(columns, y);
            if (!columns.isEmpty())
                return true;
        }
        return false;
    };
    const std::span<const LatticePoint> pattern = samplePattern(where.antialiasingOf(triangle));
    return pattern.empty() ? isDrawnAs({}) : std::ranges::any_of(pattern, isDrawnAs);
}

/// The pixels of the frame that the triangle's bounding box meets.
SampleBox boxReachOf(const Triangle &triangle, const SampledFrame &where)
{
    const FrameView &frame = where.frame;
    if (where.antialiasingOf(triangle) == Antialiasing::None)
        return intersection(boundingBoxOf(triangle), samplesOf(frame));
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    const SampleBox squares{ceilPixel(left - halfPixel), floorPixel(right + halfPixel) + 1,
                            ceilPixel(low - halfPixel), floorPixel(high + halfPixel) + 1};
    return intersection(squares, samplesOf(frame));
}

/// Whether a stroke covers the frame's first sample, and hence the whole frame if its border does
/// not enter it.
bool coversFirstSample(const StrokeStrip &strip, const FrameView &frame)
{
    std::vector<StrokePixel> quads;
    for (std::uint32_t i = 0; i < strip.quads.size(); ++i)
        quads.push_back({frame.firstColumn, frame.firstRow, i});
    return !quads.empty() && StrokeCoverage(quads, strip.quads).covers({});
}

} // namespace

SampledFrame sampledFrame(const FrameView &frame, const ScanSettings &settings,
                          Antialiasing antialiasing)
{
    return {frame, settings.fillRule, antialiasing,
            settings.arithmetic == Arithmetic::Exact && settings.isRight()};
}

SampleBox reachOf(const Triangle &triangle, const SampledFrame &where,
                  const std::array<Attribute, 3> &horizon)
{
    if (doubledArea(triangle) == 0 && where.rule != FillRule::Closed)
        return {};
    const SampleBox box = boxReachOf(triangle, where);
    if (box.isEmpty() || (where.isExact && !isDrawnIn(box, triangle, where, horizon)))
        return {};
    return box;
}

std::int64_t mostPixelsOf(const Triangle &triangle, const SampleBox &reach,
                          Antialiasing antialiasing)
{
    const std::int64_t inBox = sizeOf(reach);
    constexpr std::int64_t fewPixels = 4;
    if (inBox <= fewPixels)
        return inBox;
    double perimeter = 0;
    double boxPerimeter = 0; // each side of the box is passed back and forth
    forEachEdge(triangle, [&](double x, double y) {
        perimeter += std::sqrt(x * x + y * y);
        boxPerimeter += x + y;
    });
    double area = double(absolute(doubledArea(triangle))) / (2 * double(unitsPerPixel))
        / double(unitsPerPixel);
    if (antialiasing != Antialiasing::None) {
        area += boxPerimeter / 2 + 1; // plus the square, and the width and height of the box
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

std::int64_t mostEdgePixelsOf(const Triangle &triangle, const SampledFrame &where)
{
    // Along a border between squares an edge meets those on both sides, and at a corner all four.
    double pixels = 0;
    forEachEdge(triangle, [&](double x, double y) { pixels += std::ceil(2 * (x + y)) + 4; });
    return std::min(sizeOf(boxReachOf(triangle, where)), std::int64_t(pixels));
}

bool hasEdgePixels(const Triangle &triangle, const SampledFrame &where)
{
    if (where.antialiasingOf(triangle) == Antialiasing::None)
        return false;
    const FrameSquare square(where.frame, unitsPerPixel);
    bool isMet = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &a = triangle.vertices[i].position;
        const LatticePoint &b = triangle.vertices[(i + 1) % 3].position;
        isMet |= where.antialiasing == Antialiasing::Area
            ? square.isEnteredBy(a, b) && !square.hasAsBorder(a, b)
            : square.isMetBy(a, b);
    }
    return isMet;
}

bool isDrawnEitherWay(const Triangle &triangle, const SampledFrame &where)
{
    return !reachOf(triangle, where).isEmpty()
        || !reachOf(triangle, {where.frame, where.rule, Antialiasing::None, where.isExact})
                .isEmpty();
}

bool hasEdgePixels(const Shape &stroke, const SampledFrame &where)
{
    if (where.antialiasing == Antialiasing::None || stroke.vertices.empty() || !isStroke(stroke))
        return false;
    const FrameSquare square(where.frame, strokeUnitsPerPixel);
    const StrokeStrip strip = strokeStripOf(stroke, where.frame);
    bool isTouched = false;
    for (const StrokeQuad &quad : strip.quads) {
        for (std::size_t i = 0; i < quad.size(); ++i) {
            const StrokePoint &a = quad[i];
            const StrokePoint &b = quad[(i + 1) % quad.size()];
            const bool isByArea = where.antialiasing == Antialiasing::Area;
            if (square.isEnteredBy(a, b) && !(isByArea && square.hasAsBorder(a, b)))
                return true;
            isTouched |= !isByArea && square.isMetBy(a, b);
        }
    }
    return isTouched && coversFirstSample(strip, where.frame);
}

} // namespace pixelplumb
