// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/placinghint.h"

#include "core/methods/method.h"
#include "core/runs/tracedscene.h"
#include "widgets/look/corewords.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

struct PlacingHint {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::PlacingHint)
};

QString invitation(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return PlacingHint::tr("Click three points on the canvas to draw a triangle");
    case PrimitiveKind::Point:
        return PlacingHint::tr("Click to draw a point");
    case PrimitiveKind::Line:
        return PlacingHint::tr("Click two points to draw a line");
    case PrimitiveKind::Circle:
        return PlacingHint::tr("Click the centre and a corner of the square around the circle; "
                               "Primitives ▸ Form makes it an ellipse");
    case PrimitiveKind::Ellipse:
        return PlacingHint::tr("Click the centre and a corner of the box around the ellipse");
    case PrimitiveKind::Bezier:
        return PlacingHint::tr("Click four control points to draw a curve");
    case PrimitiveKind::Polygon:
        return PlacingHint::tr("Click the corners of a polygon, then its first corner again");
    case PrimitiveKind::Text:
        return PlacingHint::tr("Click where the text begins");
    }
    return {};
}

QString pluralOf(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return PlacingHint::tr("triangles");
    case PrimitiveKind::Point:
        return PlacingHint::tr("points");
    case PrimitiveKind::Line:
        return PlacingHint::tr("lines");
    case PrimitiveKind::Circle:
        return PlacingHint::tr("circles");
    case PrimitiveKind::Ellipse:
        return PlacingHint::tr("ellipses");
    case PrimitiveKind::Bezier:
        return PlacingHint::tr("curves");
    case PrimitiveKind::Polygon:
        return PlacingHint::tr("polygons");
    case PrimitiveKind::Text:
        return PlacingHint::tr("texts");
    }
    return {};
}

/// What a method draws: "outlined circles and ellipses".
QString drawnBy(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds += pluralOf(kind);
    const QString names = kinds.join(PlacingHint::tr(" and "));
    if (method.fills.empty())
        return names;
    const bool outlines = std::ranges::find(method.fills, ShapeFill::Outline) != method.fills.end();
    return (outlines ? PlacingHint::tr("outlined %1") : PlacingHint::tr("filled %1")).arg(names);
}

bool drawsAny(const Method &method, const Scene &scene)
{
    return (scene.hasTriangles() && method.draws(PrimitiveKind::Triangle))
        || std::ranges::any_of(scene.shapes,
                               [&](const Shape &shape) { return method.draws(shape); });
}

} // namespace

QString foreignSceneHint(const Scene &scene)
{
    if (scene.isEmpty() && scene.hiddenCount() > 0)
        return PlacingHint::tr("All primitives are hidden: Edit ▸ Show all hidden primitives.");
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    if (!method || scene.isEmpty() || drawsAny(*method, scene))
        return {};
    const Method &other = scene.hasTriangles()
        ? firstMethodFor(PrimitiveKind::Triangle)
        : firstMethodFor(scene.shapes.front(), scene.appearance);
    return PlacingHint::tr("%1 draws %2; this scene has none. %3 draws what is here.")
        .arg(methodTitle(*method), drawnBy(*method), methodTitle(other));
}

QString emptyRunText(const TracedScene *traced)
{
    if (!traced)
        return PlacingHint::tr("The run is still being recorded. Its numbers appear here.");
    const QString foreign = foreignSceneHint(traced->scene);
    if (!foreign.isEmpty())
        return foreign;
    if (traced->primitives.size() == 0)
        return PlacingHint::tr("%1. Every number of every step appears here.")
            .arg(invitation(traced->method->kinds.front()));
    return PlacingHint::tr("The method drew nothing of this scene.");
}

QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content)
{
    if (pendingVertices == 0)
        return content == FrameContent::Empty ? invitation(kind) : QString();
    if (kind == PrimitiveKind::Circle || kind == PrimitiveKind::Ellipse)
        return PlacingHint::tr("Click the corner of the box around it");
    if (kind == PrimitiveKind::Polygon && pendingVertices >= 3)
        return PlacingHint::tr("Click the next corner, or the first one to close the polygon");
    switch (pendingVertices) {
    case 1:
        return PlacingHint::tr("Click the second point");
    case 2:
        return PlacingHint::tr("Click the third point");
    case 3:
        return PlacingHint::tr("Click the fourth point");
    default:
        break;
    }
    return PlacingHint::tr("Click the next point");
}

} // namespace pixelplumb
