// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/seededrandom.h"
#include "core/oracle/polygonoracle.h"
#include "core/runs/tracedscene.h"
#include "tests/support/colours.h"
#include "tests/support/framespec.h"

#include <initializer_list>
#include <random>

/// Shared helpers of the polygon tests: short and random contours, pictures by method and by truth.
namespace pixelplumb {

using Contour = std::vector<LatticePoint>;

inline Shape polygonOf(const std::vector<Contour> &contours, ShapeFill fill = ShapeFill::EvenOdd)
{
    Shape shape;
    shape.kind = PrimitiveKind::Polygon;
    shape.fill = fill;
    for (const Contour &contour : contours) {
        if (!shape.vertices.empty())
            shape.laterContours.push_back(shape.vertices.size());
        for (const LatticePoint &point : contour)
            shape.vertices.push_back({point, green});
    }
    return shape;
}

/// A contour in whole-pixel coordinates.
inline Contour pixels(std::initializer_list<std::pair<std::int64_t, std::int64_t>> points)
{
    Contour contour;
    for (const auto &[x, y] : points)
        contour.push_back(latticePixel(x, y));
    return contour;
}

inline Scene sceneOf(const std::vector<Shape> &shapes, const FrameSpec &frame, const char *method,
                     Arithmetic arithmetic = Arithmetic::Exact)
{
    Scene scene;
    scene.frame = frame;
    scene.method = method;
    scene.settings = {arithmetic, FillRule::TopLeft, ByteRounding::Nearest};
    scene.shapes = shapes;
    return scene;
}

/// The frame as rows of `#` (green, written) and `.`, the highest row first.
inline QString pictureOf(const FrameBuffer &frame)
{
    QString text;
    const FrameView view = frame.view();
    for (std::int64_t y = view.endRow() - 1; y >= view.firstRow; --y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
            text += unpacked(*view.at(x, y)) == green ? u'#' : u'.';
        text += u'\n';
    }
    return text;
}

inline QString drawn(const Scene &scene)
{
    FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return pictureOf(frame);
}

inline QString truthOf(const Scene &scene)
{
    FrameBuffer frame(scene.frame);
    drawTruth(scene, frame);
    return pictureOf(frame);
}

/// The shape's contours in lattice units, for failure messages.
inline QString contoursText(const Shape &shape)
{
    QString text = shape.fill == ShapeFill::NonZero ? u"non-zero:"_s : u"even-odd:"_s;
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        if (std::ranges::find(shape.laterContours, i) != shape.laterContours.end())
            text += u" /"_s;
        text += u" (%1, %2)"_s.arg(shape.vertices[i].position.x).arg(shape.vertices[i].position.y);
    }
    return text;
}

inline constexpr std::array fills = {ShapeFill::EvenOdd, ShapeFill::NonZero};

/// A contour of arbitrary vertices: concave, self-intersecting, touching, running back on itself.
/// The grid makes vertices on samples, horizontal edges and collinear runs frequent.
inline Contour anyContour(SeededRandom &dice, std::int64_t side, Lattice grid)
{
    Contour contour;
    const std::int64_t count = dice.between(3, 12);
    for (std::int64_t i = 0; i < count; ++i)
        contour.push_back(
            {dice.between(-side / 4, side) * grid, dice.between(-side / 4, side) * grid});
    return contour;
}

inline Shape moved(Shape shape, const LatticePoint &by)
{
    for (Vertex &vertex : shape.vertices)
        vertex.position = {vertex.position.x + by.x, vertex.position.y + by.y};
    return shape;
}

/// Why a method refuses to draw a polygon.
inline std::optional<Rejection> rejectionOf(const Shape &shape, const char *method)
{
    return traceScene(sceneOf({shape}, frameOf(22, 22), method))->trace->setUp(0).rejection;
}

inline Shape pentagram(ShapeFill fill)
{
    return polygonOf({pixels({{8, 15}, {3, 0}, {16, 9}, {0, 9}, {13, 0}})}, fill);
}

} // namespace pixelplumb
