// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/bordercrossing.h"

#include "core/plan/drawnplane.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The offsets of a pixel's samples from its own; with area antialiasing its corners.
std::span<const LatticePoint> samplesOfPixel(Antialiasing antialiasing)
{
    static constexpr std::array<LatticePoint, 1> own = {};
    static constexpr std::array<LatticePoint, 4> corners = {{{-halfPixel, -halfPixel},
                                                             {halfPixel, -halfPixel},
                                                             {-halfPixel, halfPixel},
                                                             {halfPixel, halfPixel}}};
    if (antialiasing == Antialiasing::Area)
        return corners;
    const std::span<const LatticePoint> pattern = samplePattern(antialiasing);
    return pattern.empty() ? std::span<const LatticePoint>(own) : pattern;
}

/// The pixels with a sample or, with area antialiasing, a part within the triangle's bounding box.
SampleBox drawnBoxOf(const Triangle &triangle, Antialiasing antialiasing)
{
    if (antialiasing == Antialiasing::Area) {
        const auto [least, greatest] = boundingCornersOf(triangle);
        return {floorPixel(least.x + halfPixel), ceilPixel(greatest.x - halfPixel) + 1,
                floorPixel(least.y + halfPixel), ceilPixel(greatest.y - halfPixel) + 1};
    }
    SampleBox box;
    for (const LatticePoint &sample : samplesOfPixel(antialiasing)) {
        const SampleBox seen = boundingBoxOf(seenFrom(triangle, sample));
        if (seen.isEmpty())
            continue;
        box = box.isEmpty()
            ? seen
            : SampleBox{std::min(box.firstX, seen.firstX), std::max(box.endX, seen.endX),
                        std::min(box.firstY, seen.firstY), std::max(box.endY, seen.endY)};
    }
    return box;
}

/// Whether all samples of the frame lie on the outer side of one edge of the triangle.
bool isApart(const Triangle &triangle, const FrameView &frame, Antialiasing antialiasing)
{
    Lattice left = 0, right = 0, low = 0, high = 0; // extent of a pixel's samples
    for (const LatticePoint &sample : samplesOfPixel(antialiasing)) {
        left = std::min(left, sample.x);
        right = std::max(right, sample.x);
        low = std::min(low, sample.y);
        high = std::max(high, sample.y);
    }
    const auto cornerAt = [](std::int64_t x, std::int64_t y, Lattice alongX, Lattice alongY) {
        const LatticePoint sample = latticePixel(x, y);
        return LatticePoint{sample.x + alongX, sample.y + alongY};
    };
    const std::int64_t lastColumn = frame.endColumn() - 1;
    const std::int64_t lastRow = frame.endRow() - 1;
    const std::array<LatticePoint, 4> corners
        = {cornerAt(frame.firstColumn, frame.firstRow, left, low),
           cornerAt(lastColumn, frame.firstRow, right, low),
           cornerAt(frame.firstColumn, lastRow, left, high),
           cornerAt(lastColumn, lastRow, right, high)};
    const Int128 area = doubledArea(triangle);
    for (std::size_t i = 0; i < 3 && area != 0; ++i) {
        const LatticePoint &a = triangle.vertices[i].position;
        const LatticePoint &b = triangle.vertices[(i + 1) % 3].position;
        const bool isParting = std::ranges::all_of(corners, [&](const LatticePoint &corner) {
            const Int128 side = doubledArea(a, b, corner);
            return area > 0 ? side < 0 : side > 0;
        });
        if (isParting)
            return true;
    }
    return false;
}

/// For a triangle whose box extends beyond the frame: whether one of its samples or, with area
/// antialiasing, a part of it does. Most show that in one of a few rows; a triangle of very many
/// rows without one is left undecided.
BorderCrossing crossingOfSamples(const Triangle &triangle, const SampledFrame &where)
{
    constexpr std::int64_t fewRows = 64;
    constexpr std::int64_t mostRows = 1 << 16;
    const FrameView &frame = where.frame;
    const Antialiasing antialiasing = where.antialiasingOf(triangle);
    const bool isByArea = antialiasing == Antialiasing::Area;
    static constexpr std::array<LatticePoint, 1> own = {};
    const std::span<const LatticePoint> samples
        = isByArea ? std::span<const LatticePoint>(own) : samplesOfPixel(antialiasing);
    bool isInDoubt = false;
    for (const LatticePoint &sample : samples) {
        const SampleBox box = isByArea ? drawnBoxOf(triangle, antialiasing)
                                       : boundingBoxOf(seenFrom(triangle, sample));
        const DrawnPlane plane({&triangle, {}, {}}, sample, where);
        const auto isBeyondIn = [&](std::int64_t row) {
            RowPixels columns = {box.firstX, box.endX};
            plane.keepDrawn(columns, row);
            return !columns.isEmpty()
                && (row < frame.firstRow || row >= frame.endRow()
                    || columns.first < frame.firstColumn || columns.end > frame.endColumn());
        };
        const std::int64_t rows = box.endY - box.firstY;
        for (std::int64_t i = 0; i < fewRows && rows > fewRows; ++i) {
            if (isBeyondIn(box.firstY + rows / fewRows * i))
                return BorderCrossing::Crosses;
        }
        for (std::int64_t row = box.firstY; row < box.endY && rows <= mostRows; ++row) {
            if (isBeyondIn(row))
                return BorderCrossing::Crosses;
        }
        isInDoubt |= rows > mostRows;
    }
    return isInDoubt ? BorderCrossing::MayCross : BorderCrossing::Within;
}

} // namespace

BorderCrossing crossingOfBox(const SampleBox &box, const FrameView &frame)
{
    const SampleBox inside = intersection(box, samplesOf(frame));
    if (inside.isEmpty())
        return BorderCrossing::Outside;
    const bool isWhole = inside.firstX == box.firstX && inside.endX == box.endX
        && inside.firstY == box.firstY && inside.endY == box.endY;
    return isWhole ? BorderCrossing::Within : BorderCrossing::MayCross;
}

BorderCrossing borderCrossingOf(const Triangle &triangle, const SampledFrame &where)
{
    const Antialiasing antialiasing = where.antialiasingOf(triangle);
    if (doubledArea(triangle) == 0 && where.rule != FillRule::Closed)
        return BorderCrossing::Outside;
    const BorderCrossing crossing = crossingOfBox(drawnBoxOf(triangle, antialiasing), where.frame);
    if (crossing != BorderCrossing::MayCross)
        return crossing;
    if (isApart(triangle, where.frame, antialiasing))
        return BorderCrossing::Outside;
    return where.isExact ? crossingOfSamples(triangle, where) : BorderCrossing::Crosses;
}

} // namespace pixelplumb
