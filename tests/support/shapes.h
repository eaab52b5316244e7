// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/methods/method.h"
#include "core/scene/scene.h"

/// What the tests of lines and curves share: shapes in short, and their pictures.
namespace pixelplumb {

inline Shape lineAtUnits(LatticePoint a, LatticePoint b)
{
    Shape line;
    line.kind = PrimitiveKind::Line;
    line.vertices = {{a, {{255, 0, 40}}}, {b, {{0, 200, 90}}}};
    return line;
}

/// Whole-pixel end points.
inline Shape lineAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1)
{
    return lineAtUnits(latticePixel(x0, y0), latticePixel(x1, y1));
}

inline Shape reversed(Shape line)
{
    std::swap(line.vertices[0], line.vertices[1]);
    return line;
}

inline Shape ellipseAtUnits(LatticePoint centre, Lattice radiusX, Lattice radiusY,
                            ShapeFill fill = ShapeFill::Outline)
{
    Shape shape;
    shape.kind = radiusX == radiusY ? PrimitiveKind::Circle : PrimitiveKind::Ellipse;
    const Colour colour = {{250, 240, 30}};
    shape.vertices = {{centre, colour}, {{centre.x + radiusX, centre.y + radiusY}, colour}};
    shape.fill = fill;
    return shape;
}

inline Shape circleAt(std::int64_t x, std::int64_t y, std::int64_t radius,
                      ShapeFill fill = ShapeFill::Outline)
{
    return ellipseAtUnits(latticePixel(x, y), radius * unitsPerPixel, radius * unitsPerPixel, fill);
}

inline FrameSpec windowOf(std::int32_t width, std::int32_t height, std::int32_t firstColumn = 0,
                          std::int32_t firstRow = 0)
{
    FrameSpec spec;
    spec.width = width;
    spec.height = height;
    spec.firstColumn = firstColumn;
    spec.firstRow = firstRow;
    return spec;
}

inline CasePicture pictureOf(const Shape &shape, const FrameSpec &spec, const Drawing &drawing,
                             Arithmetic arithmetic = Arithmetic::Exact)
{
    CasePicture picture(spec, FillRule::Closed);
    picture.draw(Primitives{{}, {shape}}, {arithmetic, FillRule::Closed, ByteRounding::Nearest},
                 drawing);
    return picture;
}

inline CasePicture pictureBy(QStringView method, const Shape &shape, const FrameSpec &spec,
                             Arithmetic arithmetic = Arithmetic::Exact)
{
    return pictureOf(shape, spec, methodNamed(method)->draw, arithmetic);
}

inline CasePicture truthOf(const Shape &shape, const FrameSpec &spec)
{
    return pictureOf(shape, spec, drawTruly);
}

/// `#` written, `.` not; the highest row first.
inline QString textOf(const CasePicture &picture)
{
    const FrameSpec &spec = picture.canvas();
    QString text;
    for (std::int64_t y = spec.firstRow + spec.height - 1; y >= spec.firstRow; --y) {
        for (std::int64_t x = spec.firstColumn; x < spec.firstColumn + spec.width; ++x)
            text += picture.isWritten(x, y) ? u'#' : u'.';
        text += u'\n';
    }
    return text;
}

/// "3 pixels missing" and the like; empty where two pictures are the same.
inline QString departure(const CasePicture &drawn, const CasePicture &truth)
{
    const PictureDifference difference = differenceBetween(drawn, truth);
    return difference.isNone() ? QString() : difference.message();
}

/// The vertices in lattice units, for messages.
inline QString nameOf(const Shape &shape)
{
    QString text = nameOf(shape.kind) + QStringLiteral(", units of 1/256 px:");
    for (const Vertex &vertex : shape.vertices)
        text += QStringLiteral(" (%1, %2)").arg(vertex.position.x).arg(vertex.position.y);
    return text;
}

inline Scene sceneOf(const Shape &shape, const char *method, const FrameSpec &spec)
{
    Scene scene;
    scene.frame = spec;
    scene.method = method;
    scene.shapes = {shape};
    return scene;
}

} // namespace pixelplumb
