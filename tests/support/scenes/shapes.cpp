// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/shapes.h"

#include <algorithm>

namespace pixelplumb {

namespace {

CasePicture pictureOf(const Shape &shape, const FrameSpec &spec, const Drawing &drawing,
                      Arithmetic arithmetic)
{
    CasePicture picture(spec, FillRule::Closed);
    picture.draw(Primitives{{}, {shape}}, {arithmetic, FillRule::Closed, ByteRounding::Nearest},
                 drawing);
    return picture;
}

} // namespace

Shape lineAtUnits(LatticePoint a, LatticePoint b)
{
    Shape line;
    line.kind = PrimitiveKind::Line;
    line.vertices = {{a, {{255, 0, 40}}}, {b, {{0, 200, 90}}}};
    return line;
}

Shape lineAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1)
{
    return lineAtUnits(latticePixel(x0, y0), latticePixel(x1, y1));
}

Shape ellipseAtUnits(LatticePoint centre, Lattice radiusX, Lattice radiusY, ShapeFill fill)
{
    Shape shape;
    shape.kind = radiusX == radiusY ? PrimitiveKind::Circle : PrimitiveKind::Ellipse;
    const Colour colour = {{250, 240, 30}};
    shape.vertices = {{centre, colour}, {{centre.x + radiusX, centre.y + radiusY}, colour}};
    shape.fill = fill;
    return shape;
}

Shape circleAt(std::int64_t x, std::int64_t y, std::int64_t radius, ShapeFill fill)
{
    return ellipseAtUnits(latticePixel(x, y), radius * unitsPerPixel, radius * unitsPerPixel, fill);
}

CasePicture pictureBy(QStringView method, const Shape &shape, const FrameSpec &spec,
                      Arithmetic arithmetic)
{
    return pictureOf(shape, spec, drawingBy(*methodNamed(method), Kernels::Plain), arithmetic);
}

CasePicture truthOf(const Shape &shape, const FrameSpec &spec)
{
    return pictureOf(shape, spec, drawTruly, Arithmetic::Exact);
}

QString textOf(const CasePicture &picture)
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

QString departure(const CasePicture &drawn, const CasePicture &truth)
{
    return differencesBetween(drawn, truth).message();
}

QString nameOf(const Shape &shape)
{
    QString text = nameOf(shape.kind) + u", units of 1/256 px:"_s;
    for (const Vertex &vertex : shape.vertices)
        text += u" (%1, %2)"_s.arg(vertex.position.x).arg(vertex.position.y);
    return text;
}

Scene sceneOf(const Shape &shape, const char *method, const FrameSpec &spec)
{
    Scene scene;
    scene.frame = spec;
    scene.method = method;
    scene.shapes = {shape};
    return scene;
}

Shape bezierAt(const std::vector<LatticePoint> &controls)
{
    Shape curve;
    curve.kind = PrimitiveKind::Bezier;
    for (const LatticePoint &control : controls)
        curve.vertices.push_back({control, {{40, 250, 240}}});
    return curve;
}

Shape randomCurve(QRandomGenerator &random, Lattice step)
{
    std::vector<LatticePoint> controls;
    const int count = 3 + random.bounded(2);
    const int steps = int(60 * unitsPerPixel / step);
    for (int i = 0; i < count; ++i)
        controls.push_back({random.bounded(steps) * step, random.bounded(steps) * step});
    return bezierAt(controls);
}

bool isConnected(const CasePicture &picture)
{
    std::int64_t count = 0;
    std::vector<LatticePoint> open;
    std::vector<LatticePoint> seen;
    picture.forEachWritten([&](std::int64_t x, std::int64_t y) {
        if (count++ == 0)
            open.push_back({x, y});
    });
    while (!open.empty()) {
        const LatticePoint pixel = open.back();
        open.pop_back();
        if (std::find(seen.begin(), seen.end(), pixel) != seen.end())
            continue;
        seen.push_back(pixel);
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                if (picture.contains(pixel.x + dx, pixel.y + dy)
                    && picture.isWritten(pixel.x + dx, pixel.y + dy))
                    open.push_back({pixel.x + dx, pixel.y + dy});
            }
        }
    }
    return std::int64_t(seen.size()) == count;
}

} // namespace pixelplumb
