// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/methodtitle.h"

#include "core/methods/method.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

/// A list for lupdate only. At run time titles are looked up by the methods' text, not here.
[[maybe_unused]] constexpr const char *translatableTitles[] = {
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Column scan"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Row edge walking"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Edge equations"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Edge equations, incremental"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Edge equations, solved system"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, all pixels"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, bounding rectangle"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, incremental"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, Cramer's rule"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, off-screen point"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Midpoint outline, filled"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Column scan, half-quantum bias"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Column scan, constant ΔR"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Row edge walking, constant ΔR"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Edge equations, canonical end"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric, relative"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Bilinear interpolation"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Bilinear interpolation by rows"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Plane equation"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Barycentric interpolation"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line: DDA"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line: y = m·x + b"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line: P(t)"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line: Bresenham"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line: Bresenham, sub-pixel ends"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Circle: midpoint"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Circle: y = ±√(r² − x²)"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Circle: (r cos θ, r sin θ)"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Circle: filled by spans"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Bézier: subdivision"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Bézier path: filled"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Line or curve: one pixel wide"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Polygon by parity"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Convex polygon as a fan"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Polygon by Delaunay triangulation"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Polygon by tessellation"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Polygon outline"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Points by address"),
    QT_TRANSLATE_NOOP("pixelplumb::MethodTitle", "Text as outlines"),
};

} // namespace

QString methodTitle(const Method &method)
{
    return QCoreApplication::translate("pixelplumb::MethodTitle",
                                       method.title.toUtf8().constData());
}

} // namespace pixelplumb
