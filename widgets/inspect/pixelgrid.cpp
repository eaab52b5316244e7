// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgrid.h"

#include "core/oracle/effectoracle.h"
#include "widgets/inspect/pixelgridpainter.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int cellsPerStep = 2;

PixelGridStyle styleOf(const QWidget &widget, const DisplayOptions &options)
{
    PixelGridStyle style;
    style.palette = widget.palette();
    style.font = widget.font();
    style.font.setPixelSize(QFontInfo(widget.font()).pixelSize());
    style.lines = options.isGridShown() ? GridLines::Shown : GridLines::Hidden;
    style.notation = options.notation();
    return style;
}

} // namespace

PixelGrid::PixelGrid(Playhead *playhead, DisplayOptions *options, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_options(options)
{
    named(this, "pixelGrid", tr("Pixel grid"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(playhead, &Playhead::tracedChanged, this, &PixelGrid::announce);
    connect(playhead, &Playhead::positionChanged, this, &PixelGrid::announce);
    connect(playhead, &Playhead::pickedPixelChanged, this, &PixelGrid::announce);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &PixelGrid::announce);
    connect(options, &DisplayOptions::changed, this, qOverload<>(&QWidget::update));
    announce();
}

QSize PixelGrid::sizeHint() const { return {440, 300}; }

/// The fewest cells must stay readable.
QSize PixelGrid::minimumSizeHint() const
{
    const PixelGridStyle style = styleOf(*this, *m_options);
    const QMargins margins = pixelGridMargins(style, {}, largestRowDigits(), BoundsRoom::None);
    const double cells = fewestCells * std::ceil(leastReadableCell(style.values()));
    return {200, int(std::ceil(cells)) + margins.top() + margins.bottom()};
}

QPoint PixelGrid::centre() const
{
    if (const std::optional<QPoint> picked = m_playhead->pickedPixel())
        return *picked;
    if (!m_playhead->traced())
        return {0, 0};
    const FrameSpec &frame = m_playhead->traced()->scene.frame;
    return {frame.firstColumn + frame.width / 2, frame.firstRow + frame.height / 2};
}

/// Considers every row of the frame, so that the cells do not move.
int PixelGrid::largestRowDigits() const
{
    if (!m_playhead->traced())
        return 2;
    const FrameSpec &frame = m_playhead->traced()->scene.frame;
    return int(std::max(QString::number(frame.firstRow).size(),
                        QString::number(frame.firstRow + frame.height).size()));
}

BoundsRoom PixelGrid::boundsRoom() const
{
    const std::optional<std::size_t> span = m_playhead->currentSpan();
    const bool hasBounds = span && !m_playhead->traced()->trace->span(*span).lower.isNone();
    return hasBounds ? BoundsRoom::Kept : BoundsRoom::None;
}

ViewMapping PixelGrid::mapping() const
{
    const FrameOrigin origin
        = m_playhead->traced() ? m_playhead->traced()->scene.frame.origin : FrameOrigin::BottomLeft;
    const PixelGridStyle style = styleOf(*this, *m_options);
    const QMargins margins = pixelGridMargins(style, size(), largestRowDigits(), boundsRoom());
    const QSize inside = size().shrunkBy(margins);
    const auto fitting = [](int length, double cell) { return (int(length / cell) - 1) | 1; };
    const double least = leastReadableCell(style.values());
    int rows = m_cellCount;
    if (!m_isCountChosen)
        rows = std::clamp(fitting(inside.height(), least), fewestCells, m_cellCount);
    // As many columns as fit beside rows of this cell height.
    const int cell = std::max(1, inside.height() / rows);
    const int columns = std::clamp(fitting(inside.width(), cell), fewestCells, mostCells);
    return pixelGridMapping(size(), margins, {columns, rows}, centre(), origin,
                            devicePixelRatioF());
}

std::optional<QPoint> PixelGrid::pixelAt(const QPointF &position) const
{
    return mapping().pixelAt(position);
}

void PixelGrid::setCellCount(int count)
{
    const int bounded = std::clamp(count, fewestCells, mostCells) | 1;
    if (m_isCountChosen && bounded == m_cellCount)
        return;
    m_isCountChosen = true;
    m_cellCount = bounded;
    update();
    emit cellCountChanged(bounded);
}

void PixelGrid::announce()
{
    const std::optional<QPoint> picked = m_playhead->pickedPixel();
    setAccessibleDescription(picked && m_playhead->traced() ? describe(*picked) : QString());
    update();
}

void PixelGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    if (!m_playhead->traced()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The pixels around the picked one appear here."));
        return;
    }
    const ViewMapping cells = mapping();
    const PixelGridStyle style = styleOf(*this, *m_options);
    const PixelGridScene scene = pixelGridScene(*m_playhead, *m_options, cells);
    PixelGridPainter(painter, style, cells, scene).paint();
    if (hasFocus()) {
        const QRect grid = cells.devicePicture();
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(cells.positionOfDevice(grid.topLeft()),
                                QSizeF(grid.size()) / cells.devicePixelRatio())
                             .adjusted(-2, -2, 2, 2));
    }
}

void PixelGrid::goToWriteOf(const QPoint &pixel)
{
    const TraceNavigation navigation(*m_playhead->traced()->trace);
    const std::size_t position = m_playhead->position();
    // The write that the frame shows, else the next one to come.
    std::optional<std::size_t> write
        = navigation.writeOf(pixel, position + 1, StepDirection::Backward);
    if (!write && !m_playhead->isAheadHidden())
        write = navigation.writeOf(pixel, position, StepDirection::Forward);
    if (write)
        m_playhead->seek(*write);
}

void PixelGrid::mousePressEvent(QMouseEvent *event)
{
    const std::optional<QPoint> pixel = pixelAt(event->position());
    if (!m_playhead->traced() || !pixel)
        return;
    const FrameView frame = m_playhead->frame()->view();
    if (!frame.contains(pixel->x(), pixel->y()))
        return;
    m_playhead->pick(*pixel);
    if (event->button() == Qt::LeftButton)
        goToWriteOf(*pixel);
}

void PixelGrid::wheelEvent(QWheelEvent *event)
{
    m_wheelAngle += event->angleDelta().y();
    const int steps = m_wheelAngle / QWheelEvent::DefaultDeltasPerStep;
    m_wheelAngle -= steps * QWheelEvent::DefaultDeltasPerStep;
    if (steps != 0)
        setCellCount(mapping().frame().height
                     - steps * cellsPerStep); // turning away enlarges the cells
    event->accept();
}

void PixelGrid::keyPressEvent(QKeyEvent *event)
{
    const bool isUpward = !m_playhead->traced()
        || m_playhead->traced()->scene.frame.origin == FrameOrigin::BottomLeft;
    const int up = isUpward ? 1 : -1;
    switch (event->key()) {
    case Qt::Key_Left:
        m_playhead->nudgePick(-1, 0);
        break;
    case Qt::Key_Right:
        m_playhead->nudgePick(1, 0);
        break;
    case Qt::Key_Up:
        m_playhead->nudgePick(0, up);
        break;
    case Qt::Key_Down:
        m_playhead->nudgePick(0, -up);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        setCellCount(mapping().frame().height - cellsPerStep);
        break;
    case Qt::Key_Minus:
        setCellCount(mapping().frame().height + cellsPerStep);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_playhead->traced() && m_playhead->pickedPixel())
            goToWriteOf(*m_playhead->pickedPixel());
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

QString PixelGrid::describe(const QPoint &pixel) const
{
    const TracedScene &traced = *m_playhead->traced();
    const FrameView frame = m_playhead->frame()->view();
    QStringList lines(tr("Pixel (%1, %2)").arg(pixel.x()).arg(pixel.y()));
    if (!frame.contains(pixel.x(), pixel.y())) {
        lines.append(tr("outside the frame"));
        return lines.join(u'\n');
    }
    const auto name = [](QRgb colour) { return QColor::fromRgb(colour).name(); };
    lines.append(tr("shown %1").arg(name(*frame.at(pixel.x(), pixel.y()))));
    if (m_playhead->isAheadHidden())
        return lines.join(u'\n'); // the student is predicting the truth
    lines.append(
        tr("truth %1, when all is drawn").arg(name(*traced.truth.view().at(pixel.x(), pixel.y()))));
    const std::optional<std::size_t> triangle = currentTriangle(*m_playhead);
    if (!triangle)
        return lines.join(u'\n');
    const Triangle &geometry = traced.primitives.triangles[*triangle];
    const Antialiasing antialiasing = traced.antialiasing();
    if (!oracle::coversPart(geometry, boundaryRuleOf(traced.scene), antialiasing, pixel.x(),
                            pixel.y())) {
        lines.append(tr("not covered by triangle %1").arg(*triangle));
        return lines.join(u'\n');
    }
    const std::array<Quantity, 3> levels = exactLevelsAt(traced, *triangle, pixel.x(), pixel.y());
    if (levels[0].isNone())
        return lines.join(u'\n');
    lines.append(tr("true levels in triangle %1:").arg(*triangle));
    for (std::size_t channel = 0; channel < levels.size(); ++channel) {
        const Quantity &level = levels[channel];
        lines.append(u"%1 = %2 %3"_s.arg(channelLetters[channel])
                         .arg(displayText(level), decimalBeside(level))
                         .trimmed());
    }
    return lines.join(u'\n');
}

bool PixelGrid::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const std::optional<QPoint> pixel = pixelAt(help->pos());
    if (m_playhead->traced() && pixel)
        QToolTip::showText(help->globalPos(), describe(*pixel), this);
    else
        QToolTip::hideText();
    return true;
}

} // namespace pixelplumb
