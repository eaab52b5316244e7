// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/rejectiontext.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// " at vertex 4"
QString placeText(const std::vector<std::size_t> &vertices)
{
    return vertices.empty() ? QString() : u" at vertex %1"_s.arg(vertices.front());
}

/// "Its edges 2–3 and 5–6 cross"
QString crossingText(const std::vector<std::size_t> &vertices)
{
    return vertices.size() != 4 ? u"Edges of it cross"_s
                                : u"Its edges %1–%2 and %3–%4 cross"_s.arg(vertices[0])
                                      .arg(vertices[1])
                                      .arg(vertices[2])
                                      .arg(vertices[3]);
}

} // namespace

QString rejectionText(const Rejection &rejection)
{
    switch (rejection.reason) {
    case PrimitiveRejection::ZeroArea:
        return u"It has no area: its vertices lie on one line, and only a triangle "
               "under the closed rule is drawn as a segment. Nothing is drawn."_s;
    case PrimitiveRejection::OutsideFrame:
        return u"It lies outside the frame. Nothing is drawn."_s;
    case PrimitiveRejection::BetweenSamples:
        return u"It reaches into the frame, but by the run's tests no sample of the "
               "frame belongs to it. Nothing is drawn."_s;
    case PrimitiveRejection::NotRepresentable:
        return u"A coordinate of it lies beyond ±2¹⁵ px, more than these settings "
               "hold: fixed16.16, or exact numbers with variants. Nothing is "
               "drawn."_s;
    case PrimitiveRejection::OutlineTooLarge:
        return u"The outline of the text reaches beyond ±2³⁰ px, more than a scene "
               "holds. Nothing is drawn."_s;
    case PrimitiveRejection::VerticalLine:
        return u"The line is vertical: y = m·x + b has no m. Nothing is drawn."_s;
    case PrimitiveRejection::LineOfNoLength:
        return u"The line is a point: y = m·x + b has no m. Nothing is drawn."_s;
    case PrimitiveRejection::StrokeOfNoLength:
        return u"It is a point: a stroke of no length has no area. Nothing is "
               "drawn."_s;
    case PrimitiveRejection::NotOfThisMethod:
        return u"It is of a kind, or filled in a way, that this method does not draw."_s;
    case PrimitiveRejection::NotConvex:
        return u"It is not convex%1: only a single contour that turns one way and "
               "goes round once is tiled by a fan of triangles. Nothing is drawn."_s.arg(
                   placeText(rejection.vertices));
    case PrimitiveRejection::SelfCrossing:
        return crossingText(rejection.vertices)
            + u" between their vertices: the triangles of this method have their "
              "corners at vertices alone. Nothing is drawn."_s;
    case PrimitiveRejection::NoOutline:
        return u"The text has no outline: it is empty, or nothing but blanks. Nothing "
               "is drawn."_s;
    case PrimitiveRejection::FontMissing:
        return u"The font DejaVu Sans, from which the outlines come, is not "
               "installed (Debian: fonts-dejavu-core), or the program has no font "
               "system. Nothing is drawn."_s;
    }
    return {};
}

} // namespace pixelplumb
