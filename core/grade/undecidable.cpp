// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/undecidable.h"

#include "core/frame/framebuffer.h"
#include "core/grade/arithmeticbound.h"
#include "core/grade/picturediff.h"
#include "core/oracle/oracle.h"
#include "core/runs/sceneplan.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// The bytes that a level may become, within its bound.
struct ByteRange {
    int first = 0;
    int last = 255;

    bool contains(int byte) const { return byte >= first && byte <= last; }
};

ByteRange bytesAround(double level, double error, ByteRounding rounding)
{
    const double shift = rounding == ByteRounding::Nearest ? 0.5 : 0;
    constexpr double ownError = 1e-9; // of these doubles
    const auto byteOf
        = [shift](double value) { return int(std::clamp(std::floor(value + shift), 0.0, 255.0)); };
    return {byteOf(level - error - ownError), byteOf(level + error + ownError)};
}

/// What is known of a pixel while triangle after triangle is laid on it.
struct PixelLeeway {
    bool isOpen = false; ///< whether a triangle is on top is not decided
    bool isCovered = false;
    std::array<ByteRange, 3> bytes = {};
};

void layOn(PixelLeeway &pixel, const Triangle &triangle, const ArithmeticBound &bound,
           ByteRounding rounding, std::int64_t x, std::int64_t y)
{
    switch (bound.placeOf(x, y)) {
    case SamplePlace::Outside:
        return;
    case SamplePlace::Undecided:
        pixel.isOpen = true;
        return;
    case SamplePlace::Inside:
        break;
    }
    pixel.isOpen = false;
    pixel.isCovered = true;
    const auto exact = oracle::colourAt(triangle, x, y);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto error = bound.levelError(x, y, i);
        pixel.bytes[i] = error ? bytesAround(exact[i].toDouble(), *error, rounding) : ByteRange{};
    }
}

bool isPossible(const PixelLeeway &pixel, const Colour &colour)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (!pixel.bytes[i].contains(colour.channels[i]))
            return false;
    }
    return true;
}

/// Whether a walk may draw the sample of a triangle without area: it lies on the triangle's
/// segment, or nearer to it than the walk errs.
bool mayDrawOfSegment(const Triangle &triangle, const ArithmeticBound &bound, std::int64_t x,
                      std::int64_t y)
{
    const auto order = sortedByColumn(triangle);
    const auto pixels = [](Lattice coordinate) { return double(coordinate) / unitsPerPixel; };
    const LatticePoint &from = triangle.vertices[std::size_t(order[0])].position;
    const LatticePoint &to = triangle.vertices[std::size_t(order[2])].position;
    const double dx = pixels(to.x - from.x);
    const double dy = pixels(to.y - from.y);
    const double atX = double(x) - pixels(from.x);
    const double atY = double(y) - pixels(from.y);
    const double upward = bound.endError(SpanAxis::Column);
    const double along = bound.endError(SpanAxis::Row);
    const bool isBeside = atX < std::min(dx, 0.0) - along || atX > std::max(dx, 0.0) + along
        || atY < std::min(dy, 0.0) - upward || atY > std::max(dy, 0.0) + upward;
    const double cross = std::abs(dx * atY - dy * atX);
    return !isBeside && (cross <= upward * std::abs(dx) || cross <= along * std::abs(dy));
}

} // namespace

std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &found,
                                            Arithmetic arithmetic)
{
    std::vector<std::uint8_t> undecidable = tiesOf(scene);
    const bool isFloating = arithmetic == Arithmetic::Float32 || arithmetic == Arithmetic::Float64;
    if (!isFloating || mayCallForEffects(scene) || !scene.shapes.empty())
        return undecidable;
    const FrameSpec &frame = scene.frame;
    std::vector<PixelLeeway> pixels(undecidable.size());
    for (const Triangle &triangle : primitivesOnSamples(scene).triangles) {
        const ArithmeticBound bound(triangle, arithmetic);
        const bool hasArea = doubledArea(triangle) != 0;
        if (!bound.isProved() && (hasArea || std::isinf(bound.endError(SpanAxis::Column))))
            return undecidable; // what it paints over may not be excused
        const SampleBox box = bound.reachIn(frame);
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                const std::size_t place
                    = found.placeOf(int(x - frame.firstColumn), pictureLine(frame, y));
                if (hasArea)
                    layOn(pixels[place], triangle, bound, scene.settings.rounding, x, y);
                else if (mayDrawOfSegment(triangle, bound, x, y))
                    pixels[place].isOpen = true;
            }
        }
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const bool isColourOpen = found.hasColours && pixels[i].isCovered && found.covered[i] != 0
            && isPossible(pixels[i], found.colours[i]);
        if (pixels[i].isOpen || isColourOpen)
            undecidable[i] = 1;
    }
    return undecidable;
}

} // namespace pixelplumb
