// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/frameconvention.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString nameOf(FrameConvention convention)
{
    switch (convention) {
    case FrameConvention::AsAsked:
        return u"as asked"_s;
    case FrameConvention::OtherOrigin:
        return u"other origin"_s;
    case FrameConvention::OtherCentre:
        return u"other centre"_s;
    case FrameConvention::OtherBoth:
        break;
    }
    return u"other origin and centre"_s;
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
    const QString origin = u"y is counted from the other side than asked"_s;
    const QString centre
        = u"samples stand at the other pixel centre, half a pixel from where asked"_s;
    switch (convention) {
    case FrameConvention::AsAsked:
        return {};
    case FrameConvention::OtherOrigin:
        return origin;
    case FrameConvention::OtherCentre:
        return centre;
    case FrameConvention::OtherBoth:
        break;
    }
    return origin + u", and "_s + centre;
}

} // namespace pixelplumb
