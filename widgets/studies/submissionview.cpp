// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/submissionview.h"

#include "core/frame/framebuffer.h"
#include "widgets/look/framepainter.h"
#include "widgets/studies/submissiontext.h"

#include <QPainter>

namespace pixelplumb {

namespace {

/// A picture as an image, line by line; pixels that a raster covers are black on white.
QImage shownImage(const Picture &picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB32);
    for (int line = 0; line < picture.height; ++line) {
        auto *const pixels = reinterpret_cast<QRgb *>(image.scanLine(line));
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t place = picture.placeOf(x, line);
            const QRgb raster = picture.covered[place] != 0 ? qRgb(0, 0, 0) : qRgb(255, 255, 255);
            pixels[x] = picture.hasColours ? packed(picture.colours[place]) : raster;
        }
    }
    return image;
}

} // namespace

SubmissionView::SubmissionView(Side side, CompareLink *link, Playhead *playhead, QWidget *parent)
    : CompareView(link, playhead, parent)
    , m_side(side)
{
    const bool isStudent = side == Side::Student;
    setObjectName(isStudent ? QStringLiteral("submissionPicture")
                            : QStringLiteral("submissionExpected"));
    setAccessibleName(isStudent ? tr("The student's picture") : tr("The expected picture"));
    setToolTip(isStudent ? tr("The student's picture. A click picks the pixel.")
                         : tr("What the method draws. A click picks the pixel."));
}

void SubmissionView::setJudgement(const std::shared_ptr<const PictureJudgement> &judgement)
{
    m_judgement = judgement;
    if (!judgement)
        return setPicture({});
    setPicture(shownImage(m_side == Side::Student ? judgement->found : judgement->expected));
}

void SubmissionView::paintSigns(QPainter &painter, FramePainter &, const ViewMapping &mapping)
{
    const double cell = mapping.zoom().devicePixels / mapping.devicePixelRatio();
    if (!m_judgement || mapping.zoom().framePixels > 1 || cell < leastGlyphCell)
        return; // smaller marks would hide the picture
    const FrameSpec &frame = m_judgement->frame;
    const QRect shown = mapping.pictureIn(mapping.deviceRect(rect()) & mapping.devicePicture());
    for (int line = shown.top(); line <= shown.bottom(); ++line) {
        for (int column = shown.left(); column <= shown.right(); ++column) {
            const PixelVerdict verdict
                = m_judgement->diff.verdicts[m_judgement->expected.placeOf(column, line)];
            const QPoint pixel(frame.firstColumn + column, int(rowOfPictureLine(frame, line)));
            if (verdict != PixelVerdict::Same)
                paintMark(painter, mapping.cellOf(pixel), signOf(verdict), palette());
        }
    }
}

} // namespace pixelplumb
