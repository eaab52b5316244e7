// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/comparepicture.h"

#include "app/cli/faintpixel.h"

namespace pixelplumb::cli {

namespace {

QRgb colourOf(Disagreement reason)
{
    switch (reason) {
    case Disagreement::TieRule:
        return qRgb(230, 159, 0);
    case Disagreement::Undrawn:
        return qRgb(128, 128, 128);
    case Disagreement::Rounding:
        return qRgb(240, 228, 66);
    case Disagreement::Drift:
        return qRgb(86, 180, 233);
    case Disagreement::Precision:
        return qRgb(213, 94, 0);
    case Disagreement::Method:
        return qRgb(204, 121, 167);
    case Disagreement::NotRecorded:
    case Disagreement::None:
        break;
    }
    return qRgb(0, 0, 0);
}

} // namespace

QImage pictureOf(const Contest &contest)
{
    const AgreementMap &agreement = contest.agreement;
    const FrameSpec &frame = agreement.spec();
    const WrittenFrame &first = contest.runs.front().picture;
    QImage picture(frame.width, frame.height, QImage::Format_RGB32);
    for (int line = 0; line < picture.height(); ++line) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        const std::int64_t y = rowOfPictureLine(frame, line);
        for (int column = 0; column < picture.width(); ++column) {
            const std::int64_t x = frame.firstColumn + column;
            const bool agree = agreement.agreeingAt(x, y) == agreement.contenderCount();
            const Colour shown = first.isWritten(x, y) ? first.colourAt(x, y) : frame.background;
            pixels[column] = agree ? faint(shown) : colourOf(agreement.reasonAt(x, y));
        }
    }
    return picture;
}

} // namespace pixelplumb::cli
