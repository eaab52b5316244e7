// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/grade/redrawing.h"
#include "core/grade/spandefect.h"
#include "core/runs/sceneplan.h"

#include <algorithm>

namespace pixelplumb {

namespace {

struct LinePixel {
    std::int64_t x = 0, y = 0;
    Colour colour;
};

/// A line in sample coordinates and the pixels that its method writes, by x and then y.
struct DrawnLine {
    LatticePoint from, to;
    std::vector<LinePixel> pixels;

    bool isSteep() const { return std::abs(to.y - from.y) >= std::abs(to.x - from.x); }
};

DrawnLine drawnLine(const Scene &alone)
{
    const Picture picture = pictureOf(alone);
    const Shape shape = primitivesOnSamples(alone).shapes.front();
    DrawnLine line{shape.vertices[0].position, shape.vertices[1].position, {}};
    for (int x = 0; x < picture.width; ++x) {
        for (int row = 0; row < picture.height; ++row) {
            const std::int64_t y = alone.frame.firstRow + row;
            const std::size_t place = picture.placeOf(x, int(pictureLine(alone.frame, y)));
            if (picture.covered[place] != 0)
                line.pixels.push_back({alone.frame.firstColumn + x, y, picture.colours[place]});
        }
    }
    return line;
}

/// The lines' pixels, changed, painted one line after another.
Picture redrawnLines(const Scene &scene, const std::function<void(DrawnLine &line)> &change)
{
    Scene empty = scene;
    empty.shapes.clear();
    Picture picture = pictureOf(empty);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        DrawnLine line = drawnLine(shapeAlone(scene, i));
        change(line);
        for (const LinePixel &pixel : line.pixels) {
            const std::int64_t x = pixel.x - scene.frame.firstColumn;
            const bool isInside = x >= 0 && x < scene.frame.width && pixel.y >= scene.frame.firstRow
                && pixel.y - scene.frame.firstRow < scene.frame.height;
            if (!isInside)
                continue;
            const std::size_t place
                = picture.placeOf(int(x), int(pictureLine(scene.frame, pixel.y)));
            picture.colours[place] = pixel.colour;
            picture.covered[place] = 1;
        }
    }
    return picture;
}

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

/// The ends exchanged where x, of a steep line y, would fall.
DrawnLine ascending(DrawnLine line)
{
    const bool falls = line.isSteep() ? line.to.y < line.from.y : line.to.x < line.from.x;
    if (falls)
        std::swap(line.from, line.to);
    return line;
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

/// Bresenham's decision, begun half a pixel too far: ⌊k·Δy/Δx⌋ + 1 rows after k ≥ 1 steps, of lines
/// between samples.
void beginDecisionAtTwiceRise(DrawnLine &line)
{
    const bool isSteep = line.isSteep();
    const auto alongOf = [&](const LatticePoint &point) { return isSteep ? point.y : point.x; };
    const auto acrossOf = [&](const LatticePoint &point) { return isSteep ? point.x : point.y; };
    const std::int64_t begin = floorPixel(alongOf(line.from));
    const std::int64_t beside = floorPixel(acrossOf(line.from));
    const std::int64_t way = std::abs(floorPixel(alongOf(line.to)) - begin);
    const std::int64_t rise = floorPixel(acrossOf(line.to)) - beside;
    const auto isOnSample = [](const LatticePoint &point) {
        return point == latticePixel(floorPixel(point.x), floorPixel(point.y));
    };
    if (way == 0 || !isOnSample(line.from) || !isOnSample(line.to))
        return;
    for (LinePixel &pixel : line.pixels) {
        const std::int64_t steps = std::abs((isSteep ? pixel.y : pixel.x) - begin);
        const std::int64_t rows
            = steps == 0 ? 0 : std::min(std::abs(rise) * steps / way + 1, steps);
        (isSteep ? pixel.x : pixel.y) = beside + (rise < 0 ? -rows : rows);
    }
}
void beginSortedDecisionAtTwiceRise(DrawnLine &line)
{
    line = ascending(std::move(line));
    beginDecisionAtTwiceRise(line);
}

/// One pixel a column even where more are called for.
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

/// ⌊y⌋ in place of the nearest one; of a steep line ⌊x⌋.
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
                       QStringLiteral("lines")});
}

/// Of each line of the scene.
using ChangeLine = bool (*)(Vertex &from, Vertex &to);

void appendOfScene(std::vector<Defect> &defects, const char *id, const char *forStudent,
                   const char *forAssistant, ChangeLine change)
{
    defects.push_back({QString::fromLatin1(id),
                       QString::fromUtf8(forStudent),
                       QString::fromUtf8(forAssistant),
                       [change](Scene &changed) {
                           std::erase_if(changed.shapes, [&](Shape &shape) {
                               return !change(shape.vertices[0], shape.vertices[1]);
                           });
                           return true;
                       },
                       {},
                       {},
                       false,
                       QStringLiteral("line ends")});
}

} // namespace

std::vector<Defect> lineDefectsFor(const Scene &scene)
{
    const bool isOfLines = !scene.shapes.empty() && !scene.hasTriangles()
        && !mayCallForEffects(scene) && std::ranges::all_of(scene.shapes, [](const Shape &shape) {
               return shape.kind == PrimitiveKind::Line;
           });
    if (!isOfLines)
        return {};
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    constexpr const char *ends = "Is each end's pixel drawn, once?";
    constexpr const char *decision = "How much has the line risen half-way to the next column?";
    constexpr const char *octants = "Does it hold in all eight octants?";
    std::vector<Defect> defects;
    append(defects, "first-pixel-missing", ends, "A line's first pixel is left out.", omitFirst);
    append(defects, "last-pixel-missing", ends, "The pixel of a line's second end is left out.",
           omitLast);
    append(defects, "least-pixel-missing", ends,
           "The pixel of the end with the lesser x, of steep lines y, is left out.", omitLeast);
    if (!method.supports(Variant::OneStepShort)) // it leaves out the same
        append(defects, "greatest-pixel-missing", ends,
               "The pixel of the end with the greater x, of steep lines y, is left out.",
               omitGreatest);
    append(defects, "decision-without-dx", decision,
           "The decision begins with 2Δy in place of 2Δy − Δx, at a line's first end.",
           beginDecisionAtTwiceRise);
    append(defects, "sorted-decision-without-dx", decision,
           "The decision begins with 2Δy in place of 2Δy − Δx, at the end with the lesser x, of "
           "steep lines y.",
           beginSortedDecisionAtTwiceRise);
    if (method.id != QStringLiteral("line-slope-intercept"))
        append(defects, "one-pixel-a-column", octants,
               "Steep lines, too, have one pixel a column: x and y are not exchanged.",
               omitBetweenColumns);
    append(defects, "rows-truncated", "To which row does a pixel between two rows belong?",
           "The nearest row is not taken, but the one below; of steep lines the column before.",
           truncateAcross);
    appendOfScene(defects, "backward-lines-lost", octants,
                  "Lines whose second end is left of the first are not drawn.",
                  [](Vertex &from, Vertex &to) { return from.position.x <= to.position.x; });
    appendOfScene(defects, "falling-lines-rise", octants,
                  "From left to right y is always stepped upward: falling lines rise.",
                  [](Vertex &from, Vertex &to) {
                      Vertex &left = from.position.x <= to.position.x ? from : to;
                      Vertex &right = &left == &from ? to : from;
                      right.position.y
                          = left.position.y + std::abs(right.position.y - left.position.y);
                      return true;
                  });
    appendOfScene(defects, "colours-exchanged", "Which end has which colour?",
                  "The ends have each other's colours.", [](Vertex &from, Vertex &to) {
                      std::swap(from.colour, to.colour);
                      return true;
                  });
    appendOfScene(defects, "lines-of-first-colour", "Does the colour change along a line?",
                  "A line has its first end's colour alone.", [](Vertex &from, Vertex &to) {
                      to.colour = from.colour;
                      return true;
                  });
    return defects;
}

} // namespace pixelplumb
