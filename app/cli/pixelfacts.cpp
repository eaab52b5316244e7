// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pixelfacts.h"

#include "core/check/casepicture.h"
#include "core/runs/undrawn.h"

namespace pixelplumb::cli {

Colour finalColour(const PixelReport &report)
{
    Colour colour = report.traced.scene.frame.background;
    for (const PixelAttempt &attempt : report.attempts) {
        if (attempt.written)
            colour = unpacked(attempt.change.after);
    }
    return colour;
}

Colour trueColour(const PixelReport &report)
{
    return unpacked(*report.traced.truth.view().at(report.x, report.y));
}

Colour trueColourOfAll(const PixelReport &report)
{
    const TracedScene &traced = report.traced;
    FrameSpec pixel = traced.scene.frame;
    pixel.width = pixel.height = 1;
    pixel.firstColumn = int(report.x);
    pixel.firstRow = int(report.y);
    const FrameBuffer frame(pixel);
    FrameView view = frame.view();
    // The default off-screen point is that of the whole frame.
    view.offScreenPoint = traced.truth.view().offScreenPoint;
    drawTruly(traced.primitives, traced.scene.settings, view);
    return unpacked(*view.at(report.x, report.y));
}

QStringList undrawnAt(const PixelReport &report)
{
    const TracedScene &traced = report.traced;
    return undrawnAt(traced.primitives, *traced.method, boundaryRuleOf(traced.scene), report.x,
                     report.y);
}

SpanWords wordsFor(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return {QStringLiteral("column"), QStringLiteral("y_B"), QStringLiteral("y_T"),
                QStringLiteral("rows")};
    case SpanAxis::Row:
        return {QStringLiteral("row"), QStringLiteral("x_L"), QStringLiteral("x_R"),
                QStringLiteral("columns")};
    case SpanAxis::Free:
        break;
    }
    return {QStringLiteral("step"), {}, {}, QStringLiteral("samples")};
}

QString spanPlaceText(const PixelAttempt &attempt)
{
    return attempt.spanHeading.left(1).toLower() + attempt.spanHeading.sliced(1);
}

} // namespace pixelplumb::cli
