// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/overdrawoverlay.h"

#include "widgets/canvas/canvas.h"
#include "widgets/canvas/canvaspainter.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

namespace {

constexpr int strongest = 4; ///< number of writes from which the shade stays the same

} // namespace

OverdrawOverlay::OverdrawOverlay(Canvas *canvas, Playhead *playhead)
    : QWidget(canvas)
    , m_canvas(canvas)
    , m_playhead(playhead)
{
    setObjectName(u"overdrawMap"_s);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(canvas->rect());
    hide();
    canvas->installEventFilter(this);
    onEvents(this, {QEvent::Show}, [this] { followTrace(); });
    onEvents(this, {QEvent::PaletteChange}, [this] { makeShades(); });
    connect(playhead, &Playhead::tracedChanged, this, &OverdrawOverlay::followTrace);
    connect(playhead, &Playhead::aheadHiddenChanged, this, qOverload<>(&QWidget::update));
}

bool OverdrawOverlay::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_canvas && event->type() == QEvent::Resize)
        setGeometry(m_canvas->rect());
    return QWidget::eventFilter(watched, event);
}

void OverdrawOverlay::followTrace()
{
    if (!isVisible() || m_counted == m_playhead->sharedTraced())
        return;
    m_counted = m_playhead->sharedTraced();
    m_map = m_counted ? overdrawOf(*m_counted) : OverdrawMap();
    makeShades();
    update();
}

QString OverdrawOverlay::summary() const
{
    if (!m_counted)
        return tr("Overdraw: the scene is being drawn");
    if (m_playhead->isAheadHidden())
        return tr("Overdraw is hidden while Predict asks");
    if (m_map.overdrawnPixels() == 0 && m_map.gaps() == 0)
        return tr("Overdraw: every pixel once, no gap");
    return tr("Overdraw: %1 twice or more, %2 at most; %3")
        .arg(tr("%n pixels", nullptr, int(m_map.overdrawnPixels())),
             tr("%n times", nullptr, int(m_map.mostWrites())),
             tr("%n gaps", nullptr, int(m_map.gaps())));
}

void OverdrawOverlay::paintEvent(QPaintEvent *)
{
    const ViewMapping &mapping = m_canvas->mapping();
    const QRectF view = m_canvas->view();
    QPainter painter(this);
    painter.setClipRect(view);
    const QRect device = mapping.deviceRect(view) & mapping.devicePicture();
    if (m_counted && m_counted->scene.frame == mapping.frame() && !device.isEmpty()
        && !m_playhead->isAheadHidden()) {
        if (m_cells.size() != device.size())
            m_cells = QImage(device.size(), QImage::Format_ARGB32_Premultiplied);
        m_cells.setDevicePixelRatio(1);
        enlargePicture(m_shades, mapping, device, m_cells);
        m_cells.setDevicePixelRatio(mapping.devicePixelRatio());
        painter.drawImage(mapping.positionOfDevice(device.topLeft()), m_cells);
        drawCellNumbers(painter, mapping, view, *this, [this](const QPoint &at) {
            const int writes = m_map.writesAt(at.x(), at.y());
            const bool isTold = writes > 1 || m_map.isGapAt(at.x(), at.y());
            return isTold ? std::optional(writes) : std::nullopt;
        });
    }
    FramePainter frame(painter, mapping, palette(), view);
    frame.drawNote(summary(), {view.center().x(), view.bottom()}, NoteSide::Above);
}

QRgb OverdrawOverlay::shadeOf(std::int64_t x, std::int64_t y) const
{
    const int writes = m_map.writesAt(x, y);
    const bool isGap = m_map.isGapAt(x, y);
    if (writes == 0 && !isGap)
        return qRgba(0, 0, 0, 0);
    QColor colour = signColour(isGap ? Sign::Missing : Sign::Extra, palette());
    if (!isGap)
        colour.setAlphaF(writes == 1 ? 0.12F
                                     : 0.35F + 0.15F * float(std::min(writes, strongest) - 1));
    return qPremultiply(colour.rgba());
}

void OverdrawOverlay::makeShades()
{
    const FrameSpec &spec = m_map.spec();
    m_shades = pictureWith(
        spec, [this](const QPoint &at) { return shadeOf(at.x(), at.y()); },
        QImage::Format_ARGB32_Premultiplied);
}

} // namespace pixelplumb
