// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/rejectiontext.h"

#include <array>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// By PrimitiveRejection; %1 stands for where it shows.
constexpr std::array texts = {
    "It has no area: its vertices lie on one line, and only a triangle under the closed rule is "
    "drawn as a segment. Nothing is drawn.",
    "It lies outside the frame. Nothing is drawn.",
    "It reaches into the frame, but by the run's tests no sample of the frame belongs to it. "
    "Nothing is drawn.",
    "A coordinate of it lies beyond ±2¹⁵ px, more than these settings hold: fixed16.16, or exact "
    "numbers with variants. Nothing is drawn.",
    "The outline of the text reaches beyond ±2³⁰ px, more than a scene holds. Nothing is drawn.",
    "The line is vertical: y = m·x + b has no m. Nothing is drawn.",
    "The line is a point: y = m·x + b has no m. Nothing is drawn.",
    "It is a point: a stroke of no length has no area. Nothing is drawn.",
    "It is of a kind, or filled in a way, that this method does not draw.",
    "It is not convex%1: only a single contour that turns one way and goes round once is tiled by "
    "a fan of triangles. Nothing is drawn.",
    "%1 between their vertices: the triangles of this method have their corners at vertices alone. "
    "Nothing is drawn.",
    "The text has no outline: it is empty, or nothing but blanks. Nothing is drawn.",
    "The font DejaVu Sans, from which the outlines come, is not installed (Debian: "
    "fonts-dejavu-core), or the program has no font system. Nothing is drawn.",
};
static_assert(texts.size() == std::size_t(PrimitiveRejection::FontMissing) + 1);

/// " at vertex 4", "Its edges 2–3 and 5–6 cross"
QString placeText(const Rejection &rejection)
{
    const std::vector<std::size_t> &vertices = rejection.vertices;
    if (rejection.reason == PrimitiveRejection::NotConvex)
        return vertices.empty() ? QString() : u" at vertex %1"_s.arg(vertices.front());
    return vertices.size() != 4 ? u"Edges of it cross"_s
                                : u"Its edges %1–%2 and %3–%4 cross"_s.arg(vertices[0])
                                      .arg(vertices[1])
                                      .arg(vertices[2])
                                      .arg(vertices[3]);
}

} // namespace

QString rejectionText(const Rejection &rejection)
{
    const QString text = QString::fromUtf8(texts[std::size_t(rejection.reason)]);
    return text.contains(u"%1"_s) ? text.arg(placeText(rejection)) : text;
}

} // namespace pixelplumb
