// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/drawnline.h"

#include "core/frame/framebuffer.h"
#include "core/grade/pictures/picture.h"
#include "core/number/integer.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

namespace {

/// Keeps one pixel per column, even where steep lines need more.
void omitBetweenColumns(DrawnLine &line)
{
    const Lattice dx = line.to.x - line.from.x;
    if (!line.isSteep() || dx == 0)
        return;
    std::erase_if(line.pixels, [&](const LinePixel &pixel) {
        const Int128 above
            = Int128(pixel.x * unitsPerPixel - line.from.x) * (line.to.y - line.from.y)
            - Int128(pixel.y * unitsPerPixel - line.from.y) * dx;
        // The row is ⌊y + ½⌋: −½ ≤ y − row < ½.
        const Int128 scaled = dx > 0 ? 2 * above : -2 * above;
        const Int128 one = Int128(std::abs(dx)) * unitsPerPixel;
        return scaled < -one || scaled >= one;
    });
}

/// ⌊y⌋ in place of the nearest row; for a steep line ⌊x⌋.
void truncateAcross(DrawnLine &line)
{
    const bool isSteep = line.isSteep();
    const Lattice along = isSteep ? line.to.y - line.from.y : line.to.x - line.from.x;
    const Lattice across = isSteep ? line.to.x - line.from.x : line.to.y - line.from.y;
    if (along == 0)
        return;
    for (LinePixel &pixel : line.pixels) {
        const Lattice step
            = (isSteep ? pixel.y : pixel.x) * unitsPerPixel - (isSteep ? line.from.y : line.from.x);
        const Int128 start = isSteep ? line.from.x : line.from.y;
        const Int128 numerator
            = start * std::abs(along) + Int128(step) * (along > 0 ? across : -across);
        const auto whole
            = std::int64_t(floorDivide(numerator, Int128(std::abs(along)) * unitsPerPixel));
        (isSteep ? pixel.x : pixel.y) = whole;
    }
}

/// Of two equally near pixels the lower one, ⌈v − ½⌉, or of a steep line the left one.
void roundHalvesDown(DrawnLine &line, LineAxis axis)
{
    const bool isSteep = axis == LineAxis::Y;
    Lattice LatticePoint::*alongOf = isSteep ? &LatticePoint::y : &LatticePoint::x;
    Lattice LatticePoint::*acrossOf = isSteep ? &LatticePoint::x : &LatticePoint::y;
    const Lattice run = line.to.*alongOf - line.from.*alongOf;
    if (run == 0)
        return;
    for (LinePixel &pixel : line.pixels) {
        std::int64_t &across = isSteep ? pixel.x : pixel.y;
        const Lattice step = (isSteep ? pixel.y : pixel.x) * unitsPerPixel - line.from.*alongOf;
        const Int128 above = Int128(line.from.*acrossOf - across * unitsPerPixel) * run
            + Int128(step) * (line.to.*acrossOf - line.from.*acrossOf);
        if (2 * above == -Int128(run) * unitsPerPixel)
            --across;
    }
}

/// The end of the line that is left out; none: both are drawn.
std::optional<LatticePoint> missingEndOf(const DrawnLine &line, MissingEnd missing)
{
    const bool falls = line.isSteep() ? line.to.y < line.from.y : line.to.x < line.from.x;
    switch (missing) {
    case MissingEnd::None:
        break;
    case MissingEnd::First:
        return line.from;
    case MissingEnd::Last:
        return line.to;
    case MissingEnd::Least:
        return falls ? line.to : line.from;
    case MissingEnd::Greatest:
        return falls ? line.from : line.to;
    }
    return std::nullopt;
}

} // namespace

std::vector<LinePixel> pixelsOfMethod(const Scene &alone)
{
    const Picture picture = pictureOf(alone);
    std::vector<LinePixel> pixels;
    for (int x = 0; x < picture.width; ++x) {
        for (int row = 0; row < picture.height; ++row) {
            const std::int64_t y = alone.frame.firstRow + row;
            const std::size_t place = picture.placeOf(x, int(pictureLine(alone.frame, y)));
            if (picture.covered[place] != 0)
                pixels.push_back({alone.frame.firstColumn + x, y, picture.colours[place]});
        }
    }
    return pixels;
}

void changePixels(DrawnLine &line, const LineBugs &bugs, LineAxis steps)
{
    if (bugs.steepPixels == SteepPixels::OneAColumn)
        omitBetweenColumns(line);
    if (bugs.rounding == AcrossRounding::Down)
        truncateAcross(line);
    if (bugs.rounding == AcrossRounding::HalvesDown)
        roundHalvesDown(line, steps);
    if (const auto missing = missingEndOf(line, bugs.missing)) {
        std::erase_if(line.pixels, [&](const LinePixel &pixel) {
            return pixel.x == floorPixel(missing->x + halfPixel)
                && pixel.y == floorPixel(missing->y + halfPixel);
        });
    }
    if (bugs.steepWriting == SteepWriting::Exchanged && line.isSteep()) {
        for (LinePixel &pixel : line.pixels)
            std::swap(pixel.x, pixel.y);
    }
}

} // namespace pixelplumb
