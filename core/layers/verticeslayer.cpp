// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/polygons/contours.h"

namespace pixelplumb {

namespace {

void appendVertex(const LayerMoment &moment, std::size_t number, const LatticePoint &vertex,
                  LayerDrawing &drawing)
{
    QString name
        = QStringLiteral("P%1 (%2, %3)")
              .arg(QString::number(number), moment.inScene(vertex.x), moment.inScene(vertex.y));
    drawing.points.push_back({placeOf(vertex), LayerInk::Mark});
    drawing.labels.push_back({name.replace(u'-', QChar(0x2212)), placeOf(vertex), LayerInk::Mark});
}

void appendTriangle(const LayerMoment &moment, LayerDrawing &drawing)
{
    const std::array<LatticePoint, 3> corners = moment.corners();
    for (std::size_t i = 0; i < 3; ++i) {
        drawing.lines.push_back({placeOf(corners[i]), placeOf(corners[(i + 1) % 3])});
        appendVertex(moment, i, corners[i], drawing);
    }
}

void appendShape(const LayerMoment &moment, LayerDrawing &drawing)
{
    const Shape &shape = moment.shape();
    if (shape.kind == PrimitiveKind::Polygon) {
        const Contours contours = contoursOf(shape);
        for (const ContourEdge &edge : contours.edges)
            drawing.lines.push_back({placeOf(edge.from), placeOf(edge.to)});
    }
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        const LatticePoint &vertex = shape.vertices[i].position;
        if (i > 0 && shape.kind != PrimitiveKind::Polygon)
            drawing.lines.push_back({placeOf(shape.vertices[i - 1].position), placeOf(vertex)});
        appendVertex(moment, i, vertex, drawing);
    }
}

void drawVertices(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (moment.primitives().isTriangle(moment.primitive))
        appendTriangle(moment, drawing);
    else
        appendShape(moment, drawing);
}

} // namespace

Layer verticesLayer()
{
    return {.id = QStringLiteral("vertices"),
            .title = QStringLiteral("Vertices and edges"),
            .toolTip = QStringLiteral(
                "The vertices by the names that the method gives them, with their coordinates, and "
                "the edges between them; of a curve its control polygon."),
            .source = QStringLiteral("Assignment (Borst), “The Triangle Awakens”"),
            .kinds = {PrimitiveKind::Triangle, PrimitiveKind::Line, PrimitiveKind::Bezier,
                      PrimitiveKind::Polygon},
            .draw = drawVertices};
}

} // namespace pixelplumb
