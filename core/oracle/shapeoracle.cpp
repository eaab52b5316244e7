// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/shapeoracle.h"

#include "core/oracle/circleoracle.h"
#include "core/oracle/curveoracle.h"
#include "core/oracle/filledcurveoracle.h"
#include "core/oracle/lineoracle.h"
#include "core/oracle/polygonoracle.h"
#include "core/polygons/textoutlines.h"

namespace pixelplumb::oracle {

bool covers(const Shape &shape, FrameOrigin origin, std::int64_t x, std::int64_t y)
{
    switch (shape.kind) {
    case PrimitiveKind::Point:
        return pointsCover(shape, x, y);
    case PrimitiveKind::Line:
        return lineCovers(shape, x, y);
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return ellipseCovers(shape, x, y);
    case PrimitiveKind::Bezier:
        return shape.fill == ShapeFill::Outline ? curveCovers(shape, x, y)
                                                : filledCurveCovers(shape, origin, x, y);
    case PrimitiveKind::Polygon:
        return polygonCovers(shape, origin, x, y);
    case PrimitiveKind::Text:
        return polygonCovers(sharedOutlinesOf(shape)->polygon, origin, x, y);
    case PrimitiveKind::Triangle: // never a shape
        break;
    }
    return false;
}

void draw(const Shape &shape, ByteRounding rounding, FrameView frame)
{
    switch (shape.kind) {
    case PrimitiveKind::Point:
        drawPoints(shape, frame);
        break;
    case PrimitiveKind::Line:
        drawLine(shape, rounding, frame);
        break;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        drawEllipse(shape, frame);
        break;
    case PrimitiveKind::Bezier:
        if (shape.fill == ShapeFill::Outline)
            drawCurve(shape, frame);
        else
            drawFilledCurve(shape, frame);
        break;
    case PrimitiveKind::Polygon:
        drawPolygon(shape, frame);
        break;
    case PrimitiveKind::Text:
        drawPolygon(sharedOutlinesOf(shape)->polygon, frame);
        break;
    case PrimitiveKind::Triangle: // never a shape
        break;
    }
}

} // namespace pixelplumb::oracle
