// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"
#include "core/polygons/contours.h"

namespace pixelplumb {

namespace {

void appendVertex(const LayerMoment &moment, const QString &name, const LatticePoint &vertex,
                  LayerDrawing &drawing)
{
    QString text = u"%1 (%2, %3)"_s.arg(name, moment.inScene(vertex.x), moment.inScene(vertex.y));
    drawing.points.push_back({placeOf(vertex), LayerInk::Mark});
    drawing.labels.push_back({withMinus(text), placeOf(vertex), LayerInk::Mark});
}

void appendTriangle(const LayerMoment &moment, LayerDrawing &drawing)
{
    const std::array<LatticePoint, 3> corners = moment.corners();
    const std::array<int, 3> order = moment.trace().setUp(moment.primitive).order;
    for (std::size_t i = 0; i < 3; ++i) {
        drawing.lines.push_back({placeOf(corners[i]), placeOf(corners[(i + 1) % 3])});
        // Both names if the method's differs from the scene's, as in the set-up's words.
        const bool isSorted = order[i] != int(i);
        appendVertex(moment, isSorted ? u"P%1 = vertex %2"_s.arg(i).arg(order[i]) : u"P%1"_s.arg(i),
                     corners[i], drawing);
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
        appendVertex(moment, u"P%1"_s.arg(i), vertex, drawing);
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
    return {.id = "vertices",
            .title = QT_TRANSLATE_NOOP("core", "Vertices and edges"),
            .toolTip = "The vertices by the names that the method gives them, with the scene's "
                       "number where it sorts them, their coordinates, and the edges between them; "
                       "of a curve its control polygon.",
            .source = "Assignment (Borst), “The Triangle Awakens”",
            .kinds = {PrimitiveKind::Triangle, PrimitiveKind::Line, PrimitiveKind::Bezier,
                      PrimitiveKind::Polygon},
            .draw = drawVertices};
}

} // namespace pixelplumb
