// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/compare/compareview.h"

#include "widgets/canvas/canvaspainter.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/compare/comparelink.h"

namespace pixelplumb {

namespace {

bool isWrittenBySomeone(const Contest &contest, std::int64_t x, std::int64_t y)
{
    return std::ranges::any_of(
        contest.runs, [x, y](const ContenderRun &run) { return run.picture.isWritten(x, y); });
}

} // namespace

CompareView::CompareView(CompareLink *link, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_link(link)
    , m_playhead(playhead)
{
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    const auto repaint = qOverload<>(&QWidget::update);
    connect(link, &CompareLink::changed, this, repaint);
    connect(playhead, &Playhead::pickedPixelChanged, this, repaint);
}

void CompareView::setPicture(const QImage &picture)
{
    m_picture = picture;
    update();
}

void CompareView::setMessage(const QString &message)
{
    m_message = message;
    update();
}

ViewMapping CompareView::mapping() const
{
    return m_link->mappingFor(size(), devicePixelRatioF(), fractionOf(*this));
}

std::optional<QPoint> CompareView::pixelAt(const QPointF &position) const
{
    return view().contains(position) ? mapping().pixelAt(position) : std::nullopt;
}

void CompareView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Mid));
    if (m_picture.isNull()) {
        painter.fillRect(rect(), palette().color(QPalette::Base));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(view().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         m_message);
        return;
    }
    const ViewMapping shown = mapping();
    const QRect device = shown.deviceRect(view()) & shown.devicePicture();
    if (!device.isEmpty() && m_picture.size() == QSize(shown.frame().width, shown.frame().height)) {
        m_cells.setDevicePixelRatio(1);
        enlargePicture(m_picture, shown, device, m_cells);
        blendGrid(m_cells, shown, device, gridColour(shown));
        m_cells.setDevicePixelRatio(devicePixelRatioF());
        painter.drawImage(shown.positionOfDevice(device.topLeft()), m_cells);
    }
    FramePainter frame(painter, shown, palette(), view());
    frame.drawFrameEdge();
    paintSigns(painter, frame, shown);
    if (const std::optional<QPoint> picked = m_playhead->pickedPixel())
        frame.drawPickedPixel(*picked);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void CompareView::paintSigns(QPainter &, FramePainter &, const ViewMapping &) { }

void CompareView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        m_pressed = event->position();
}

void CompareView::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_pressed)
        return;
    const QPointF way = event->position() - *m_pressed;
    if (!m_dragged && way.manhattanLength() < QApplication::startDragDistance())
        return;
    const QPointF from = m_dragged.value_or(*m_pressed);
    const ViewMapping shown = mapping();
    m_link->moveBy(shown, view(), shown.deviceAt(event->position()) - shown.deviceAt(from));
    m_dragged = event->position();
}

void CompareView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const bool wasClick = m_pressed && !m_dragged;
    m_pressed.reset();
    m_dragged.reset();
    const std::optional<QPoint> pixel = pixelAt(event->position());
    if (wasClick && pixel && !m_picture.isNull())
        m_playhead->pick(*pixel);
}

void CompareView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (const std::optional<QPoint> pixel = pixelAt(event->position()))
        m_link->lookAt(*pixel);
}

void CompareView::wheelEvent(QWheelEvent *event)
{
    m_wheelRest += event->angleDelta().y();
    constexpr int notch = QWheelEvent::DefaultDeltasPerStep;
    for (; m_wheelRest >= notch; m_wheelRest -= notch)
        m_link->zoomIn(mapping(), view(), event->position());
    for (; m_wheelRest <= -notch; m_wheelRest += notch)
        m_link->zoomOut(mapping(), view(), event->position());
    event->accept();
}

void CompareView::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        return m_playhead->nudgePick(-1, 0);
    case Qt::Key_Right:
        return m_playhead->nudgePick(1, 0);
    case Qt::Key_Up:
    case Qt::Key_Down: {
        const bool growsUpward = m_link->frame().origin == FrameOrigin::BottomLeft;
        const bool up = event->key() == Qt::Key_Up;
        return m_playhead->nudgePick(0, up == growsUpward ? 1 : -1);
    }
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return m_link->zoomIn(mapping(), view(), view().center());
    case Qt::Key_Minus:
        return m_link->zoomOut(mapping(), view(), view().center());
    default:
        QWidget::keyPressEvent(event);
    }
}

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
    named(this, "agreementMap", tr("Agreement map"),
          tr("How many agree on each pixel. A click tells the reason."));
    onEvents(this, {QEvent::PaletteChange}, [this] { makePicture(); });
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
    setPicture(pictureWith(spec, [&](const QPoint &at) {
        const int agreeing = agreement.agreeingAt(at.x(), at.y());
        const bool isUntouched
            = agreeing == contenders && !isWrittenBySomeone(*m_contest, at.x(), at.y());
        return isUntouched ? untouched : colours[std::size_t(agreeing)];
    }));
}

void AgreementView::paintSigns(QPainter &painter, FramePainter &, const ViewMapping &mapping)
{
    if (!m_contest)
        return;
    const AgreementMap &agreement = m_contest->agreement;
    drawCellNumbers(painter, mapping, rect(), *this, [&agreement](const QPoint &at) {
        const int agreeing = agreement.agreeingAt(at.x(), at.y());
        return agreeing == agreement.contenderCount() ? std::nullopt : std::optional(agreeing);
    });
}

} // namespace pixelplumb
