// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/shapedefect.h"

#include "core/grade/bugs/linedefect.h"
#include "core/grade/bugs/scenedefect.h"
#include "core/scan/lines/linestep.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace pixelplumb {

namespace {

constexpr const char *octantQuestion = "Does it hold in all eight octants?";
constexpr const char *colourQuestion = "Which end has which colour?";
constexpr const char *clipQuestion
    = "Through which pixels goes the part of a line that is inside the frame?";
constexpr const char *radiusQuestion = "How far from its centre is a circle's outermost pixel?";
constexpr const char *centreQuestion = "In which pixel is a circle's centre?";
constexpr const char *insideQuestion = "Which samples are inside where contours overlap?";
constexpr const char *contourQuestion = "Where does each contour begin and end?";

/// Changes a shape of the scene; false: it is not drawn.
using ChangeShape = bool (*)(Shape &shape, const FrameSpec &frame);

struct ShapeRow {
    PrimitiveKind kind;
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    ChangeShape change;
};

bool isSteep(const Shape &line)
{
    return lineAxisOf(line.vertices[0].position, line.vertices[1].position) == LineAxis::Y;
}

Lattice nearestPixel(Lattice coordinate)
{
    return floorPixel(coordinate + halfPixel) * unitsPerPixel;
}
Lattice pixelBelow(Lattice coordinate) { return floorPixel(coordinate) * unitsPerPixel; }

/// Cuts a line at the first and the last sample along one coordinate; an end where it is cut
/// becomes a whole pixel. False where nothing is left.
bool cut(Shape &line, Lattice LatticePoint::*along, Lattice LatticePoint::*across, Lattice first,
         Lattice last, Lattice (*whole)(Lattice))
{
    const Vertex from = line.vertices[0];
    const Vertex to = line.vertices[1];
    const Lattice run = to.position.*along - from.position.*along;
    const auto borderOf
        = [&](const Vertex &end) { return std::clamp(end.position.*along, first, last); };
    for (Vertex &end : line.vertices) {
        const Lattice border = borderOf(end);
        if (border == end.position.*along)
            continue;
        if (borderOf(from) == borderOf(to))
            return false;
        const auto moved = [&](Lattice start, Lattice goal) {
            const Int128 way = Int128(goal - start) * (border - from.position.*along);
            return start + Lattice(floorDivide<Int128>(way, run));
        };
        end.position.*along = border;
        end.position.*across = whole(moved(from.position.*across, to.position.*across));
        for (std::size_t i = 0; i < 3; ++i)
            end.colour.channels[i]
                = std::uint8_t(moved(from.colour.channels[i], to.colour.channels[i]));
    }
    return true;
}

/// Cohen and Sutherland's way: an end outside the frame moves to its border, first in x, then in y.
bool clip(Shape &line, const FrameSpec &frame, Lattice (*whole)(Lattice))
{
    const Lattice offset = sampleOffset(frame);
    const auto sample = [offset](std::int64_t pixel) { return pixel * unitsPerPixel + offset; };
    return cut(line, &LatticePoint::x, &LatticePoint::y, sample(frame.firstColumn),
               sample(frame.firstColumn + frame.width - 1), whole)
        && cut(line, &LatticePoint::y, &LatticePoint::x, sample(frame.firstRow),
               sample(frame.firstRow + frame.height - 1), whole);
}

void changeRadii(Shape &circle, Lattice times, Lattice over, Lattice more)
{
    const LatticePoint centre = circle.vertices[0].position;
    LatticePoint &corner = circle.vertices[1].position;
    corner = {centre.x + (corner.x - centre.x) * times / over + more,
              centre.y + (corner.y - centre.y) * times / over + more};
}
/// Along both axes.
void moveCircle(Shape &circle, Lattice way)
{
    for (Vertex &vertex : circle.vertices)
        vertex.position = {vertex.position.x + way, vertex.position.y + way};
}
bool hasRadius(const Shape &circle)
{
    return circle.vertices[1].position.x >= circle.vertices[0].position.x
        && circle.vertices[1].position.y >= circle.vertices[0].position.y;
}

std::span<const ShapeRow> shapeRows()
{
    using S = Shape;
    using F = FrameSpec;
    constexpr auto line = PrimitiveKind::Line;
    constexpr auto circle = PrimitiveKind::Circle;
    constexpr auto polygon = PrimitiveKind::Polygon;
    static const std::vector<ShapeRow> rows = {
        {line, "steep-lines-lost", octantQuestion, "Steep lines are not drawn.",
         [](S &shape, const F &) { return !isSteep(shape); }},
        {line, "falling-lines-level", octantQuestion,
         "Of lines that fall from their first end to their second nothing steps downward: they "
         "stay in their first row, steep ones in their first column.",
         [](S &shape, const F &) {
             Lattice LatticePoint::*across = isSteep(shape) ? &LatticePoint::x : &LatticePoint::y;
             Lattice &end = shape.vertices[1].position.*across;
             end = std::max(end, shape.vertices[0].position.*across);
             return true;
         }},
        {line, "backward-lines-lost", octantQuestion,
         "Lines whose second end is left of the first are not drawn.",
         [](S &shape, const F &) {
             return shape.vertices[0].position.x <= shape.vertices[1].position.x;
         }},
        {line, "falling-lines-rise", octantQuestion,
         "From left to right y is always stepped upward: falling lines rise.",
         [](S &shape, const F &) {
             const bool isForward = shape.vertices[0].position.x <= shape.vertices[1].position.x;
             const LatticePoint &left = shape.vertices[isForward ? 0 : 1].position;
             LatticePoint &right = shape.vertices[isForward ? 1 : 0].position;
             right.y = left.y + std::abs(right.y - left.y);
             return true;
         }},
        {line, "colours-exchanged", colourQuestion, "The ends have each other's colours.",
         [](S &shape, const F &) {
             std::swap(shape.vertices[0].colour, shape.vertices[1].colour);
             return true;
         }},
        {line, "lines-of-first-colour", "Does the colour change along a line?",
         "A line has its first end's colour alone.",
         [](S &shape, const F &) {
             shape.vertices[1].colour = shape.vertices[0].colour;
             return true;
         }},
        {line, "clipped-ends-rounded", clipQuestion,
         "A line that leaves the frame is cut at the border, the cut is rounded to the nearest "
         "pixel, and the line is drawn from there: its pixels are not those of the whole line.",
         [](S &shape, const F &frame) { return clip(shape, frame, nearestPixel); }},
        {line, "clipped-ends-truncated", clipQuestion,
         "A line that leaves the frame is cut at the border, the cut is cast to a whole pixel, and "
         "the line is drawn from there: its pixels are not those of the whole line.",
         [](S &shape, const F &frame) { return clip(shape, frame, pixelBelow); }},
        {line, "crossing-lines-lost", clipQuestion,
         "A line that leaves the frame is not drawn, nor what of it is inside.",
         [](S &shape, const F &frame) {
             const S whole = shape;
             return clip(shape, frame, nearestPixel) && shape == whole;
         }},
        {circle, "radius-one-more", radiusQuestion, "Radii are a pixel too large.",
         [](S &shape, const F &) {
             changeRadii(shape, 1, 1, unitsPerPixel);
             return true;
         }},
        {circle, "radius-one-less", radiusQuestion, "Radii are a pixel too small.",
         [](S &shape, const F &) {
             changeRadii(shape, 1, 1, -unitsPerPixel);
             return hasRadius(shape);
         }},
        {circle, "radius-doubled", radiusQuestion,
         "Circles are twice as large: the radius is doubled, as where a diameter is asked for.",
         [](S &shape, const F &) {
             changeRadii(shape, 2, 1, 0);
             return true;
         }},
        {circle, "radius-as-diameter", radiusQuestion,
         "Circles are half as large: the radius is taken for the diameter.",
         [](S &shape, const F &) {
             changeRadii(shape, 1, 2, 0);
             return true;
         }},
        {circle, "centre-one-more", centreQuestion, "Centres are a pixel too large in x and in y.",
         [](S &shape, const F &) {
             moveCircle(shape, unitsPerPixel);
             return true;
         }},
        {circle, "centre-one-less", centreQuestion, "Centres are a pixel too small in x and in y.",
         [](S &shape, const F &) {
             moveCircle(shape, -unitsPerPixel);
             return true;
         }},
        {circle, "centre-half-more", centreQuestion,
         "Centres are half a pixel too large in x and in y.",
         [](S &shape, const F &) {
             moveCircle(shape, halfPixel);
             return true;
         }},
        {circle, "centre-half-less", centreQuestion,
         "Centres are half a pixel too small in x and in y, as where they are cut to whole pixels "
         "and not rounded.",
         [](S &shape, const F &) {
             moveCircle(shape, -halfPixel);
             return true;
         }},
        {circle, "centre-exchanged", centreQuestion, "x and y of centres are exchanged.",
         [](S &shape, const F &) {
             const LatticePoint centre = shape.vertices[0].position;
             const Lattice way = centre.y - centre.x;
             for (Vertex &vertex : shape.vertices)
                 vertex.position = {vertex.position.x + way, vertex.position.y - way};
             return true;
         }},
        {polygon, "even-odd-for-non-zero", insideQuestion,
         "Samples around which a contour winds twice are outside: crossings are counted, even and "
         "odd, in place of windings.",
         [](S &shape, const F &) {
             if (shape.fill == ShapeFill::NonZero)
                 shape.fill = ShapeFill::EvenOdd;
             return true;
         }},
        {polygon, "non-zero-for-even-odd", insideQuestion,
         "Samples around which a contour winds twice are inside: windings are counted in place of "
         "crossings, even and odd.",
         [](S &shape, const F &) {
             if (shape.fill == ShapeFill::EvenOdd)
                 shape.fill = ShapeFill::NonZero;
             return true;
         }},
        {polygon, "last-vertex-forgotten", contourQuestion,
         "A polygon's last vertex is left out: the one before it is joined to the first.",
         [](S &shape, const F &) {
             shape.vertices.pop_back();
             return shape.vertices.size() >= 3;
         }},
        {polygon, "outline-left-open", contourQuestion,
         "An outline's last edge, from its last vertex back to its first, is not drawn.",
         [](S &shape, const F &) {
             // There and back: all edges but that one, twice.
             const std::size_t last = shape.vertices.size() - 1;
             if (shape.fill == ShapeFill::Outline && shape.laterContours.empty()) {
                 for (std::size_t i = last; i > 1; --i)
                     shape.vertices.push_back(shape.vertices[i - 1]);
             }
             return true;
         }},
        {polygon, "first-contour-alone", contourQuestion,
         "Of several contours only the first is drawn: holes are filled.",
         [](S &shape, const F &) {
             if (!shape.laterContours.empty())
                 shape.vertices.resize(shape.laterContours.front());
             shape.laterContours.clear();
             return true;
         }},
        {polygon, "contours-joined", contourQuestion,
         "Several contours are read as one: the last vertex of each is joined to the first of the "
         "next.",
         [](S &shape, const F &) {
             shape.laterContours.clear();
             return true;
         }},
    };
    return rows;
}

} // namespace

std::vector<Defect> shapeDefectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    if (scene.hasTriangles() || mayCallForEffects(scene))
        return defects;
    for (const ShapeRow &row : shapeRows()) {
        const auto change = [&row](Scene &changed) {
            std::erase_if(changed.shapes, [&](Shape &shape) {
                return shape.kind == row.kind && !row.change(shape, changed.frame);
            });
            return true;
        };
        appendWhereItApplies(defects, scene, QString::fromLatin1(lineEndsChoice),
                             {QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
                              QString::fromUtf8(row.forAssistant), change});
    }
    std::ranges::move(redrawnShapeDefectsFor(scene), std::back_inserter(defects));
    return defects;
}

} // namespace pixelplumb
