// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/placinghint.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("pixelplumb::PlacingHint", text);
}

QString invitation(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return tr("Click three points to draw a triangle");
    case PrimitiveKind::Point:
        return tr("Click to draw a point");
    case PrimitiveKind::Line:
        return tr("Click two points to draw a line");
    case PrimitiveKind::Circle:
        return tr("Click the centre and a corner of the square around the circle");
    case PrimitiveKind::Ellipse:
        return tr("Click the centre and a corner of the box around the ellipse");
    case PrimitiveKind::Bezier:
        return tr("Click four control points to draw a curve");
    case PrimitiveKind::Polygon:
        return tr("Click the corners of a polygon, then its first corner again");
    case PrimitiveKind::Text:
        return tr("Click where the text begins");
    }
    return {};
}

} // namespace

QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content)
{
    if (pendingVertices == 0)
        return content == FrameContent::Empty ? invitation(kind) : QString();
    if (kind == PrimitiveKind::Circle || kind == PrimitiveKind::Ellipse)
        return tr("Click the corner of the box around it");
    if (kind == PrimitiveKind::Polygon && pendingVertices >= 3)
        return tr("Click the next corner, or the first one to close the polygon");
    switch (pendingVertices) {
    case 1:
        return tr("Click the second point");
    case 2:
        return tr("Click the third point");
    case 3:
        return tr("Click the fourth point");
    default:
        break;
    }
    return tr("Click the next point");
}

} // namespace pixelplumb
