// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/shapeexamples.h"

namespace pixelplumb {

namespace {

Shape shapeOf(PrimitiveKind kind, const std::vector<Vertex> &vertices,
              ShapeFill fill = ShapeFill::Outline)
{
    Shape shape;
    shape.kind = kind;
    shape.vertices = vertices;
    shape.fill = fill;
    return shape;
}

constexpr Colour ochre = {{204, 119, 34}};
constexpr Colour white = {{255, 255, 255}};

} // namespace

QByteArray sceneOfPrimitives(const QByteArray &primitives, const QByteArray &members)
{
    return "{ \"pixelplumb\": 1, \"frame\": { \"width\": 8, \"height\": 8 },\n" + members
        + "\"primitives\": [\n" + primitives + "\n] }";
}

QByteArray json(const char *text) { return QByteArray(text).replace('\'', '"'); }

std::vector<ShapeExample> shapeExamples()
{
    const auto at = [](std::int64_t x, std::int64_t y) { return latticePixel(x, y); };
    Shape pierced = shapeOf(PrimitiveKind::Polygon,
                            {{at(0, 0), ochre},
                             {at(9, 0), ochre},
                             {at(0, 9), ochre},
                             {at(1, 1), ochre},
                             {at(3, 1), ochre},
                             {at(1, 3), ochre}},
                            ShapeFill::NonZero);
    pierced.laterContours = {3};
    Shape path = shapeOf(PrimitiveKind::Bezier,
                         {{at(0, 0), ochre},
                          {at(9, 0), ochre},
                          {at(0, 9), ochre},
                          {at(0, 9), ochre},
                          {at(3, 1), ochre},
                          {at(1, 3), ochre},
                          {at(0, 0), ochre}},
                         ShapeFill::EvenOdd);
    path.laterContours = {3};
    Shape text = shapeOf(PrimitiveKind::Text, {{at(3, 2), ochre}}, ShapeFill::NonZero);
    text.text = "say “é” \"\\\n\t\x01";
    text.textHeight = 12 * unitsPerPixel + 64;
    return {
        {json("{ 'points': [[1, 2], ['7/2', -4]], 'colors': ['#cc7722', '#ffffff'] }"),
         shapeOf(PrimitiveKind::Point, {{at(1, 2), ochre}, {{896, -1024}, white}})},
        {json("{ 'line': [[20, 41], [30, 44]], 'colors': ['#cc7722', '#ffffff'] }"),
         shapeOf(PrimitiveKind::Line, {{at(20, 41), ochre}, {at(30, 44), white}})},
        {json("{ 'circle': { 'centre': [5, 6], 'radius': '1/256' }, 'color': '#cc7722', 'fill': "
              "'outline' }"),
         shapeOf(PrimitiveKind::Circle, {{at(5, 6), ochre}, {{5 * 256 + 1, 6 * 256 + 1}, ochre}})},
        {json("{ 'circle': { 'centre': [5, 6], 'radius': 4 }, 'color': '#cc7722', 'fill': 'filled' "
              "}"),
         shapeOf(PrimitiveKind::Circle, {{at(5, 6), ochre}, {at(9, 10), ochre}},
                 ShapeFill::NonZero)},
        {json("{ 'ellipse': { 'centre': [5, 6], 'radii': [4, 3] }, 'color': '#cc7722', 'fill': "
              "'outline' }"),
         shapeOf(PrimitiveKind::Ellipse, {{at(5, 6), ochre}, {at(9, 9), ochre}})},
        {json("{ 'bezier': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722' }"),
         shapeOf(PrimitiveKind::Bezier, {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}})},
        {json("{ 'bezier': [[0, 0], [1, 5], [7, 1], [2, 2]], 'color': '#cc7722' }"),
         shapeOf(PrimitiveKind::Bezier,
                 {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}, {at(2, 2), ochre}})},
        {json("{ 'polygon': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722', 'fill': 'even-odd' }"),
         shapeOf(PrimitiveKind::Polygon, {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}},
                 ShapeFill::EvenOdd)},
        {json("{ 'polygon': { 'contours': [[[0, 0], [9, 0], [0, 9]], [[1, 1], [3, 1], [1, 3]]] }, "
              "'color': '#cc7722', 'fill': 'non-zero' }"),
         pierced},
        {json("{ 'text': 'say “é” \\\"\\\\\\u000a\\u0009\\u0001', 'at': [3, 2], 'height': '49/4', "
              "'color': '#cc7722' }"),
         text},
        {json("{ 'polygon': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722', 'fill': 'outline' }"),
         shapeOf(PrimitiveKind::Polygon,
                 {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}})},
        {json("{ 'bezier': [[0, 0], [1, 5], [7, 1]], 'color': '#cc7722', 'fill': 'non-zero' }"),
         shapeOf(PrimitiveKind::Bezier, {{at(0, 0), ochre}, {at(1, 5), ochre}, {at(7, 1), ochre}},
                 ShapeFill::NonZero)},
        {json("{ 'bezier': { 'path': [[[0, 0], [9, 0], [0, 9]], [[0, 9], [3, 1], [1, 3], [0, 0]]] "
              "}, 'color': '#cc7722', 'fill': 'even-odd' }"),
         path},
    };
}

} // namespace pixelplumb
