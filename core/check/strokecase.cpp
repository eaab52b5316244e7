// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/strokecase.h"

#include "core/shade/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Side in pixels of the window around each examined place.
constexpr std::int32_t windowSide = 48;

/// The ends and the middle of a line or curve; a circle's or ellipse's highest, lowest, leftmost
/// and rightmost points.
std::vector<LatticePoint> placesOf(const Shape &shape)
{
    const LatticePoint &a = shape.vertices.front().position;
    const LatticePoint &b = shape.vertices.back().position;
    if (shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse)
        return {{b.x, a.y}, {2 * a.x - b.x, a.y}, {a.x, b.y}, {a.x, 2 * a.y - b.y}};
    return {a, b, {(a.x + b.x) / 2, (a.y + b.y) / 2}};
}

FrameSpec windowAround(const LatticePoint &place)
{
    FrameSpec window;
    window.width = windowSide;
    window.height = windowSide;
    window.firstColumn = std::int32_t(floorPixel(place.x) - windowSide / 2);
    window.firstRow = std::int32_t(floorPixel(place.y) - windowSide / 2);
    return window;
}

QString nameOfAntialiasing(Antialiasing antialiasing)
{
    switch (antialiasing) {
    case Antialiasing::Samples4:
        return QStringLiteral("4 samples");
    case Antialiasing::Samples16:
        return QStringLiteral("16 samples");
    case Antialiasing::None:
    case Antialiasing::Area:
        break;
    }
    return QStringLiteral("area");
}

} // namespace

bool isStrokeCase(const HardCase &hardCase, const Method &method)
{
    return method.supports(Effect::Antialiasing) && !hardCase.shapes.empty()
        && std::ranges::all_of(hardCase.shapes, isStroke);
}

QStringList strokeShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing)
{
    QStringList shortfalls;
    for (const Shape &shape : hardCase.shapes) {
        for (const Antialiasing antialiasing :
             {Antialiasing::Area, Antialiasing::Samples4, Antialiasing::Samples16}) {
            Primitives primitives{{}, {shape}};
            primitives.appearance.antialiasing = antialiasing;
            for (const LatticePoint &place : placesOf(shape)) {
                CasePicture picture(windowAround(place), settings.fillRule);
                CasePicture truth(windowAround(place), settings.fillRule);
                picture.draw(primitives, settings, drawing);
                truth.draw(primitives, settings, drawTruly);
                const DifferenceCounts differences = differencesBetween(picture, truth);
                if (differences.total() > 0)
                    shortfalls
                        += QStringLiteral("%1, near (%2, %3): %4")
                               .arg(nameOfAntialiasing(antialiasing),
                                    QString::number(floorPixel(place.x)),
                                    QString::number(floorPixel(place.y)), differences.message());
            }
        }
    }
    return shortfalls;
}

} // namespace pixelplumb
