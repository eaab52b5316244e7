// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/grade/bugs/shapedefect.h"
#include "core/grade/scan/redrawing.h"
#include "core/polygons/contours.h"
#include "core/scan/polygons/polygonrows.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr const char *arcQuestion = "Which of the eight arcs is a pixel mirrored into?";
constexpr const char *edgesQuestion = "How many edges has a contour?";

/// Whether a pixel is drawn that lies so far from the circle's centre, px.
using KeepsPixel = bool (*)(std::int64_t x, std::int64_t y);

Picture keptPixels(const Scene &alone, KeepsPixel keeps)
{
    const LatticePoint centre = primitivesOnSamples(alone).shapes.front().vertices[0].position;
    Picture picture = pictureOf(alone);
    for (int line = 0; line < picture.height; ++line) {
        const std::int64_t y = rowOfPictureLine(alone.frame, line);
        for (int x = 0; x < picture.width; ++x)
            picture.covered[picture.placeOf(x, line)]
                &= keeps(alone.frame.firstColumn + x - floorPixel(centre.x + halfPixel),
                         y - floorPixel(centre.y + halfPixel))
                ? 1
                : 0;
    }
    return picture;
}

/// A polygon between whose crossings, two by two, samples are filled, without the last edge of each
/// contour. By either rule: an open contour winds around nothing.
Picture openPolygon(const Scene &alone)
{
    const Shape polygon = primitivesOnSamples(alone).shapes.front();
    std::vector<ContourEdge> edges = contoursOf(polygon).edges;
    std::vector<std::size_t> ends = polygon.laterContours;
    ends.push_back(edges.size());
    for (auto end = ends.rbegin(); end != ends.rend(); ++end)
        edges.erase(edges.begin() + std::ptrdiff_t(*end) - 1);
    Picture picture = emptyPicture(alone.frame);
    for (int line = 0; line < picture.height; ++line) {
        const std::int64_t y = rowOfPictureLine(alone.frame, line);
        std::vector<std::int64_t> crossings; // ⌈x⌉
        for (const ContourEdge &edge : edges) {
            const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
            const Interval rows = rowsCrossed(alone.frame.origin);
            if (y < firstSampleFrom(low, rows) || y >= endSampleAt(high, rows))
                continue;
            const Int128 way = Int128(edge.to.x - edge.from.x) * (y * unitsPerPixel - edge.from.y);
            const Int128 rise = edge.to.y - edge.from.y;
            crossings.push_back(std::int64_t(ceilDivide<Int128>(
                rise < 0 ? -(edge.from.x * rise + way) : edge.from.x * rise + way,
                absolute(rise) * unitsPerPixel)));
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            for (std::int64_t x = crossings[i]; x < crossings[i + 1]; ++x) {
                if (picture.contains(int(x - alone.frame.firstColumn), line))
                    picture.covered[picture.placeOf(int(x - alone.frame.firstColumn), line)] = 1;
            }
        }
    }
    for (std::size_t place = 0; place < picture.size(); ++place)
        picture.colours[place] = polygon.vertices.front().colour;
    return picture;
}

/// The scene with each shape painted by `draw`, which may leave one to its method.
Picture painted(const Scene &scene,
                const std::function<std::optional<Picture>(const Scene &alone)> &draw)
{
    Scene others = scene;
    others.shapes.clear();
    Picture picture = pictureOf(others);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Scene alone = shapeAlone(scene, i);
        const auto own = draw(alone);
        const Picture drawn = own ? *own : pictureOf(alone);
        for (std::size_t place = 0; place < drawn.size(); ++place) {
            if (drawn.covered[place] == 0)
                continue;
            picture.colours[place] = drawn.colours[place];
            picture.covered[place] = 1;
        }
    }
    return picture;
}

void appendRedrawn(std::vector<Defect> &defects, const char *id, const char *forStudent,
                   const char *forAssistant,
                   const std::function<std::optional<Picture>(const Scene &alone)> &draw)
{
    defects.push_back({.id = QString::fromLatin1(id),
                       .forStudent = QString::fromUtf8(forStudent),
                       .forAssistant = QString::fromUtf8(forAssistant),
                       .redraw = [draw](const Scene &scene) { return painted(scene, draw); }});
}

void appendArcs(std::vector<Defect> &defects)
{
    const auto add = [&](const char *id, const char *forAssistant, KeepsPixel keeps) {
        appendRedrawn(defects, id, arcQuestion, forAssistant, [keeps](const Scene &alone) {
            return alone.shapes.front().kind == PrimitiveKind::Circle
                ? std::optional(keptPixels(alone, keeps))
                : std::nullopt;
        });
    };
    add("octants-not-exchanged",
        "Only the arcs at the top and at the bottom are drawn: x and y are not exchanged for the "
        "others.",
        [](std::int64_t x, std::int64_t y) { return std::abs(x) <= std::abs(y); });
    add("one-quarter-alone",
        "Only the quarter towards larger x and y is drawn: it is not mirrored into the others.",
        [](std::int64_t x, std::int64_t y) { return x >= 0 && y >= 0; });
    add("axis-pixels-missing",
        "The pixels straight above, below and beside the centre are left out: arcs begin at 1, not "
        "at 0.",
        [](std::int64_t x, std::int64_t y) { return x != 0 && y != 0; });
}

} // namespace

std::vector<Defect> redrawnShapeDefectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    const auto has = [&scene](auto isOne) { return std::ranges::any_of(scene.shapes, isOne); };
    if (has([](const Shape &shape) { return shape.kind == PrimitiveKind::Circle; }))
        appendArcs(defects);
    const auto isFilled = [](const Shape &shape) {
        return shape.kind == PrimitiveKind::Polygon && shape.fill != ShapeFill::Outline;
    };
    if (has(isFilled))
        appendRedrawn(defects, "last-edge-forgotten", edgesQuestion,
                      "A contour's last edge, from its last vertex back to its first, is not among "
                      "the edges: rows are filled from the first of their crossings to the second.",
                      [isFilled](const Scene &alone) {
                          return isFilled(alone.shapes.front()) ? std::optional(openPolygon(alone))
                                                                : std::nullopt;
                      });
    return defects;
}

} // namespace pixelplumb
