// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/effectreason.h"
#include "core/shade/strokes/strokestrip.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The kinds of primitives that are antialiased where the scene is drawn as it asks.
QString antialiasedWord(const NeedsTally &tally)
{
    if (tally.askedStrokes == 0)
        return QStringLiteral("triangle");
    return tally.askedTriangles == 0 ? QStringLiteral("line or curve")
                                     : QStringLiteral("triangle, line or curve");
}

/// That what the scene has is never antialiased, or is not drawn.
QString nothingAntialiased(const Primitives &primitives)
{
    const bool hasStrokes = std::ranges::any_of(primitives.shapes, isStroke);
    const QString strokes = "line or curve one pixel wide";
    if (primitives.triangles.empty())
        return hasStrokes ? QStringLiteral("no %1 is drawn in the frame").arg(strokes)
                          : QStringLiteral("only triangles, and lines and curves one pixel wide, "
                                           "have more than one sample a pixel");
    return hasStrokes ? QStringLiteral("no triangle is drawn in the frame, nor any ") + strokes
                      : QStringLiteral("no triangle is drawn in the frame");
}

} // namespace

QString antialiasingReason(const Primitives &primitives, const NeedsTally &tally)
{
    const Antialiasing antialiasing = primitives.appearance.antialiasing;
    const auto ofSamples = [&](int samples) {
        const QString pixel = tally.askedStrokes == 0
            ? QStringLiteral("that an edge passes through")
            : QStringLiteral("that the border of a %1 passes through").arg(antialiasedWord(tally));
        return QStringLiteral("the scene asks for %1 samples in each pixel %2")
            .arg(QString::number(samples), pixel);
    };
    if (antialiasing == Antialiasing::None)
        return QStringLiteral("the scene asks for one sample a pixel");
    const bool isCalledFor = tally.of[Effect::Antialiasing].primitives > 0;
    if (!isCalledFor && tally.askedTriangles + tally.askedStrokes == 0)
        return nothingAntialiased(primitives);
    if (!isCalledFor)
        return antialiasing == Antialiasing::Area
            ? QStringLiteral("no edge crosses a pixel of the frame: each pixel is covered "
                             "entirely or not at all")
            : QStringLiteral("no edge of a %1 meets a pixel of the frame: each pixel is sampled "
                             "once, at its centre")
                  .arg(tally.askedTriangles == 0 ? QStringLiteral("stroke")
                                                 : QStringLiteral("triangle with an area"));
    switch (antialiasing) {
    case Antialiasing::None:
        break;
    case Antialiasing::Samples4:
        return ofSamples(4);
    case Antialiasing::Samples16:
        return ofSamples(16);
    case Antialiasing::Area:
        return QStringLiteral("the scene asks for the exact area of each pixel that a %1 covers")
            .arg(antialiasedWord(tally));
    }
    return {};
}

} // namespace pixelplumb
