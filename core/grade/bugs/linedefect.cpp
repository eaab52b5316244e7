// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/bresenhamdefect.h"
#include "core/grade/bugs/drawnline.h"
#include "core/grade/bugs/linechoice.h"
#include "core/grade/bugs/spandefect.h"
#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "core/scan/lines/linestep.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

bool isAt(const LinePixel &pixel, const LatticePoint &point)
{
    return pixel.x == floorPixel(point.x + halfPixel) && pixel.y == floorPixel(point.y + halfPixel);
}

void omitFirst(DrawnLine &line)
{
    std::erase_if(line.pixels, [&](const LinePixel &pixel) { return isAt(pixel, line.from); });
}
void omitLast(DrawnLine &line)
{
    std::erase_if(line.pixels, [&](const LinePixel &pixel) { return isAt(pixel, line.to); });
}

void omitLeast(DrawnLine &line)
{
    line = ascending(std::move(line));
    omitFirst(line);
}
void omitGreatest(DrawnLine &line)
{
    line = ascending(std::move(line));
    omitLast(line);
}

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

/// What alone is no mistake, for both pixels are equally near.
void appendHalvesDown(std::vector<Defect> &defects, const Scene &scene)
{
    const bool isEquation = scene.method == "line-slope-intercept";
    const auto redraw = [isEquation](const Scene &drawn) {
        return redrawnLines(drawn, [isEquation](DrawnLine &line) {
            roundHalvesDown(line, isEquation ? LineAxis::X : lineAxisOf(line.from, line.to));
        });
    };
    defects.push_back({.id = u"rounds-halves-down"_s,
                       .forStudent = u"Which of two equally near pixels is drawn?"_s,
                       .forAssistant
                       = u"Halves are rounded down, ⌈v − ½⌉ in place of ⌊v + ½⌋. Both pixels are "
                         "equally near: that alone is no mistake."_s,
                       .redraw = redraw,
                       .choice = u"lines"_s,
                       .isRightAlone = true});
}

void exchangeSteep(DrawnLine &line)
{
    if (!line.isSteep())
        return;
    for (LinePixel &pixel : line.pixels)
        std::swap(pixel.x, pixel.y);
}

void append(std::vector<Defect> &defects, const char *id, const char *forStudent,
            const char *forAssistant, void (*change)(DrawnLine &line))
{
    defects.push_back({QString::fromLatin1(id),
                       QString::fromUtf8(forStudent),
                       QString::fromUtf8(forAssistant),
                       {},
                       [change](const Scene &scene) { return redrawnLines(scene, change); },
                       {},
                       false,
                       u"lines"_s});
}

} // namespace

std::vector<Defect> lineDefectsFor(const Scene &scene)
{
    if (!isOfLines(scene))
        return {};
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    constexpr const char *ends = "Is each end's pixel drawn, once?";
    constexpr const char *octants = "Does it hold in all eight octants?";
    std::vector<Defect> defects;
    append(defects, "first-pixel-missing", ends, "A line's first pixel is left out.", omitFirst);
    append(defects, "last-pixel-missing", ends, "The pixel of a line's second end is left out.",
           omitLast);
    append(defects, "least-pixel-missing", ends,
           "The pixel of the end with the lesser x, of steep lines y, is left out.", omitLeast);
    if (!method.supports(Variant::OneStepShort)) // otherwise that variant leaves out the same pixel
        append(defects, "greatest-pixel-missing", ends,
               "The pixel of the end with the greater x, of steep lines y, is left out.",
               omitGreatest);
    if (method.supports(Variant::StayAtZero))
        std::ranges::move(bresenhamDefects(), std::back_inserter(defects));
    else if (drawsNearestPixels(scene))
        appendHalvesDown(defects, scene);
    if (method.id != u"line-slope-intercept"_s)
        append(defects, "one-pixel-a-column", octants,
               "Steep lines, too, have one pixel a column: x and y are not exchanged.",
               omitBetweenColumns);
    append(defects, "rows-truncated", "To which row does a pixel between two rows belong?",
           "The nearest row is not taken, but the one below; of steep lines the column before.",
           truncateAcross);
    append(defects, "steep-lines-exchanged", octants,
           "Of steep lines x and y are exchanged, but not again where a pixel is written.",
           exchangeSteep);
    return defects;
}

} // namespace pixelplumb
