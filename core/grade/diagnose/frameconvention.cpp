// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/frameconvention.h"

namespace pixelplumb {

QString nameOf(FrameConvention convention)
{
    switch (convention) {
    case FrameConvention::AsAsked:
        return QStringLiteral("as asked");
    case FrameConvention::OtherOrigin:
        return QStringLiteral("other origin");
    case FrameConvention::OtherCentre:
        return QStringLiteral("other centre");
    case FrameConvention::OtherBoth:
        break;
    }
    return QStringLiteral("other origin and centre");
}

Scene sceneIn(Scene scene, FrameConvention convention)
{
    FrameSpec &frame = scene.frame;
    if (convention == FrameConvention::OtherOrigin || convention == FrameConvention::OtherBoth)
        frame.origin
            = frame.origin == FrameOrigin::TopLeft ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
    if (convention == FrameConvention::OtherCentre || convention == FrameConvention::OtherBoth)
        frame.pixelCentre
            = frame.pixelCentre == PixelCentre::Half ? PixelCentre::Integer : PixelCentre::Half;
    return scene;
}

QString sentenceOf(FrameConvention convention)
{
    const QString origin = QStringLiteral("y is counted from the other side than asked");
    const QString centre
        = QStringLiteral("samples stand at the other pixel centre, half a pixel from where asked");
    const QString judged = QStringLiteral("; judged by that convention");
    switch (convention) {
    case FrameConvention::AsAsked:
        return {};
    case FrameConvention::OtherOrigin:
        return origin + judged;
    case FrameConvention::OtherCentre:
        return centre + judged;
    case FrameConvention::OtherBoth:
        break;
    }
    return origin + QStringLiteral(", and ") + centre + judged;
}

} // namespace pixelplumb
