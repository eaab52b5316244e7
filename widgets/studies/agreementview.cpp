// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/agreementview.h"

#include "widgets/look/framepainter.h"
#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"

#include <QEvent>
#include <QPainter>

namespace pixelplumb {

namespace {

bool isWrittenBySomeone(const Contest &contest, std::int64_t x, std::int64_t y)
{
    return std::ranges::any_of(
        contest.runs, [x, y](const ContenderRun &run) { return run.picture.isWritten(x, y); });
}

} // namespace

QColor agreementColour(int agreeing, int contenders, const QPalette &palette)
{
    if (agreeing >= contenders) {
        constexpr double share = 0.22; // of the text colour
        const QColor base = palette.color(QPalette::Base);
        const QColor text = palette.color(QPalette::Text);
        const auto mixed = [](int from, int to) { return int(from + share * (to - from)); };
        return {mixed(base.red(), text.red()), mixed(base.green(), text.green()),
                mixed(base.blue(), text.blue())};
    }
    if (agreeing == 1)
        return signColour(Sign::Extra, palette);
    return signColour(agreeing == 2 ? Sign::Clamp : Sign::Tie, palette);
}

AgreementView::AgreementView(CompareLink *link, Playhead *playhead, QWidget *parent)
    : CompareView(link, playhead, parent)
{
    setObjectName(QStringLiteral("agreementMap"));
    setAccessibleName(tr("Agreement map"));
    setToolTip(tr("How many agree on each pixel. A click tells the reason."));
    connect(playhead, &Playhead::aheadHiddenChanged, this, &AgreementView::makePicture);
    connect(playhead, &Playhead::positionChanged, this, [this, playhead] {
        if (playhead->isAheadHidden() && isVisible())
            makePicture();
    });
}

void AgreementView::setContest(const std::shared_ptr<const Contest> &contest)
{
    m_contest = contest;
    makePicture();
}

void AgreementView::makePicture()
{
    if (!m_contest) {
        setPicture({});
        return;
    }
    const FrameSpec &spec = m_contest->scene.frame;
    const AgreementMap &agreement = m_contest->agreement;
    const int contenders = agreement.contenderCount();
    std::vector<QRgb> colours;
    for (int agreeing = 0; agreeing <= contenders; ++agreeing)
        colours.push_back(agreementColour(agreeing, contenders, palette()).rgb());
    const QRgb untouched = palette().color(QPalette::Base).rgb();
    QImage picture(spec.width, spec.height, QImage::Format_RGB32);
    for (int line = 0; line < spec.height; ++line) {
        const std::int64_t y = rowOfPictureLine(spec, line);
        auto *const pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        for (int column = 0; column < spec.width; ++column) {
            const std::int64_t x = std::int64_t(spec.firstColumn) + column;
            const int agreeing = agreement.agreeingAt(x, y);
            const bool isUntouched
                = agreeing == contenders && !isWrittenBySomeone(*m_contest, x, y);
            pixels[column] = isUntouched || !playhead()->mayTell(x, y)
                ? untouched
                : colours[std::size_t(agreeing)];
        }
    }
    setPicture(picture);
}

void AgreementView::paintSigns(QPainter &painter, FramePainter &, const ViewMapping &mapping)
{
    const double cell = mapping.zoom().devicePixels / mapping.devicePixelRatio();
    if (!m_contest || mapping.zoom().framePixels > 1 || cell < leastGlyphCell)
        return;
    const FrameSpec &spec = m_contest->scene.frame;
    const AgreementMap &agreement = m_contest->agreement;
    const QRect shown = mapping.pictureIn(mapping.deviceRect(rect()) & mapping.devicePicture());
    QFont digits = font();
    digits.setBold(true);
    digits.setPixelSize(std::min(int(cell), 22));
    painter.setFont(digits);
    for (int line = shown.top(); line <= shown.bottom(); ++line) {
        const std::int64_t y = rowOfPictureLine(spec, line);
        for (int column = shown.left(); column <= shown.right(); ++column) {
            const int x = spec.firstColumn + column;
            const int agreeing = agreement.agreeingAt(x, y);
            if (agreeing == agreement.contenderCount() || !playhead()->mayTell(x, y))
                continue;
            painter.setPen(isDark(palette()) ? Qt::black : Qt::white);
            painter.drawText(mapping.cellOf({x, int(y)}), Qt::AlignCenter,
                             QString::number(agreeing));
        }
    }
}

void AgreementView::showEvent(QShowEvent *event)
{
    makePicture(); // the current step may have changed
    CompareView::showEvent(event);
}

void AgreementView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        makePicture();
    CompareView::changeEvent(event);
}

} // namespace pixelplumb
