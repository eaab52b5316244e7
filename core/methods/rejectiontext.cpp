// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/rejectiontext.h"

namespace pixelplumb {

QString rejectionText(PrimitiveRejection rejection)
{
    switch (rejection) {
    case PrimitiveRejection::ZeroArea:
        return QStringLiteral("It has no area: its vertices lie on one line, and only the closed "
                              "rule paints a segment. Nothing is drawn.");
    case PrimitiveRejection::OutsideFrame:
        return QStringLiteral("It lies outside the frame. Nothing is drawn.");
    case PrimitiveRejection::NotRepresentable:
        return QStringLiteral("A coordinate does not fit this arithmetic. Nothing is drawn.");
    case PrimitiveRejection::VerticalLine:
        return QStringLiteral("The line is vertical: y = m·x + b has no m. Nothing is drawn.");
    case PrimitiveRejection::NotOfThisMethod:
        return QStringLiteral("This method does not draw primitives of its kind.");
    case PrimitiveRejection::NotConvex:
        return QStringLiteral("It is not convex: only a single contour that turns one way and goes "
                              "round once is tiled by a fan of triangles. Nothing is drawn.");
    case PrimitiveRejection::SelfCrossing:
        return QStringLiteral("Edges of it cross between their vertices: no corner of a triangle "
                              "can stand there, because crossings are no lattice points. Nothing "
                              "is drawn.");
    case PrimitiveRejection::FontMissing:
        return QStringLiteral("The font DejaVu Sans, from which the outlines come, is not "
                              "installed (Debian: fonts-dejavu-core), or the program has no font "
                              "system. Nothing is drawn.");
    }
    return {};
}

} // namespace pixelplumb
