// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelhistorypanel.h"

#include "widgets/inspect/delegates.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/pixelhistorymodel.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int reasonLines = 3; // always kept free, so that the list mostly stays in place

QToolButton *runButton(const char *name, const QString &text, const QString &toolTip,
                       QWidget *parent)
{
    QToolButton *button = namedButton(name, text, toolTip, parent);
    button->setAutoRaise(true);
    return button;
}

QString swatchHtml(QRgb colour)
{
    const QString name = QColor::fromRgb(colour).name();
    return u"<span style='background-color:%1'>&nbsp;&nbsp;&nbsp;&nbsp;</span> %1"_s.arg(name);
}

} // namespace

PixelHistoryPanel::PixelHistoryPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_model(new PixelHistoryModel(this))
    , m_heading(new QLabel(this))
    , m_reasonArea(new QScrollArea(this))
    , m_reason(new QLabel(m_reasonArea))
    , m_attempts(new QTreeView(this))
{
    named(this, "pixelHistory", tr("History of the picked pixel"));

    m_heading->setObjectName(u"pixelHistoryHeading"_s);
    m_heading->setTextFormat(Qt::RichText);
    m_heading->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_heading->setMinimumWidth(1); // a long heading must not widen the window
    m_reason->setObjectName(u"pixelHistoryReason"_s);
    m_reason->setTextFormat(Qt::RichText);
    m_reason->setWordWrap(true);
    m_reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_reasonArea->setObjectName(u"pixelHistoryReasonArea"_s);
    m_reasonArea->setFrameShape(QFrame::NoFrame);
    m_reasonArea->setFocusPolicy(Qt::NoFocus); // its text takes the focus
    m_reasonArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_reasonArea->setWidgetResizable(true);
    m_reasonArea->setWidget(m_reason);
    m_reasonArea->viewport()->setAutoFillBackground(false);
    m_reason->setAutoFillBackground(false);

    QToolButton *previous
        = runButton("runToPreviousWrite", tr("◀ Write"),
                    tr("Run back to the previous write of the picked pixel"), this);
    QToolButton *next = runButton("runToNextWrite", tr("Write ▶"),
                                  tr("Run on to the next write of the picked pixel"), this);

    named(m_attempts, "pixelHistoryTree", tr("Attempts of the triangles"));
    m_attempts->setFrameShape(QFrame::NoFrame);
    m_attempts->setHeaderHidden(true);
    m_attempts->setUniformRowHeights(true);
    m_attempts->setIndentation(16);
    m_attempts->setModel(m_model);
    m_attempts->setItemDelegate(new PixelHistoryDelegate(this));
    m_attempts->header()->setStretchLastSection(true);
    m_attempts->header()->setMinimumSectionSize(24);
    m_attempts->setMinimumHeight(fontMetrics().height() + 4); // one attempt

    setFocusProxy(m_attempts);

    auto *headingRow = withParts(new QHBoxLayout, {{m_heading, 1}, previous, next}, 0);
    auto *layout = withParts(new QVBoxLayout(this), {headingRow, {m_attempts, 1}, m_reasonArea}, 4);
    layout->setContentsMargins(8, 4, 0, 0);

    onEvents(this, {QEvent::Resize}, [this] {
        fitColumns();
        fitReason();
    });
    connect(previous, &QToolButton::clicked, playhead,
            [playhead] { playhead->runToPickedPixel(StepDirection::Backward); });
    connect(next, &QToolButton::clicked, playhead,
            [playhead] { playhead->runToPickedPixel(StepDirection::Forward); });
    connect(playhead, &Playhead::tracedChanged, this, &PixelHistoryPanel::scheduleUpdate);
    connect(playhead, &Playhead::pickedPixelChanged, this, &PixelHistoryPanel::scheduleUpdate);
    connect(playhead, &Playhead::positionChanged, this, &PixelHistoryPanel::followPosition);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &PixelHistoryPanel::scheduleUpdate);
    connect(m_attempts, &QTreeView::activated, this, &PixelHistoryPanel::goToWrite);
    connect(m_attempts->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &PixelHistoryPanel::showReason);
    takePixel();
}

QSize PixelHistoryPanel::sizeHint() const { return {440, 200}; }

void PixelHistoryPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale)
        takePixel();
    // Its height is known only after the layout.
    QTimer::singleShot(0, m_attempts, [this] { m_attempts->scrollTo(m_attempts->currentIndex()); });
}

/// Shows all of the reason if it fits into half of the panel; else it scrolls.
void PixelHistoryPanel::fitReason()
{
    const int least = fontMetrics().lineSpacing() * reasonLines;
    const int needed = m_reason->heightForWidth(m_reasonArea->viewport()->width());
    m_reasonArea->setFixedHeight(std::clamp(needed, least, std::max(least, height() / 2)));
}

void PixelHistoryPanel::scheduleUpdate()
{
    m_isStale = true;
    if (isVisible())
        takePixel();
}

void PixelHistoryPanel::takePixel()
{
    m_isStale = false;
    m_model->setPosition(m_playhead->position());
    m_model->setPixel(m_playhead->sharedTraced(), m_playhead->pickedPixel(), m_playhead->ahead());
    const QModelIndex decisive = m_model->decisiveRow();
    for (int row = 0; row < m_model->rowCount(); ++row)
        m_attempts->setFirstColumnSpanned(row, {}, true);
    m_attempts->expand(decisive);
    fitColumns();
    select(decisive);
    describePixel();
}

/// The last column takes the remaining width; if there is none, the list scrolls sideways.
void PixelHistoryPanel::fitColumns()
{
    QHeaderView *header = m_attempts->header();
    header->setStretchLastSection(false);
    for (int column = 0; column < m_model->columnCount(); ++column)
        m_attempts->resizeColumnToContents(column);
    header->setStretchLastSection(header->length() < m_attempts->viewport()->width());
}

void PixelHistoryPanel::followPosition()
{
    if (!isVisible()) {
        m_isStale = true;
        return;
    }
    if (m_playhead->isAheadHidden()) {
        takePixel(); // what was ahead may be shown now
        return;
    }
    m_model->setPosition(m_playhead->position());
    if (const QModelIndex current = m_model->currentRow(); current.isValid())
        select(current);
    describePixel();
}

void PixelHistoryPanel::select(const QModelIndex &attempt)
{
    m_attempts->expand(attempt);
    m_attempts->selectionModel()->setCurrentIndex(
        attempt, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_attempts->scrollTo(attempt);
    showReason(attempt);
}

void PixelHistoryPanel::describePixel()
{
    const std::optional<QPoint> pixel = m_playhead->pickedPixel();
    const TracedScene *traced = m_playhead->traced();
    if (!pixel || !traced) {
        m_heading->setText(tr("<b>No pixel is picked</b>"));
        m_reason->setText(
            tr("Click one in the pixel grid, or on the canvas with the tool Inspect."));
        fitReason();
        return;
    }
    const FrameView frame = m_playhead->frame()->view();
    if (!frame.contains(pixel->x(), pixel->y()))
        return;
    if (m_model->isSomethingHidden() && m_model->rowCount() == 0) {
        m_heading->setText(
            tr("<b>(%1, %2)</b> is still ahead: predict it").arg(pixel->x()).arg(pixel->y()));
        return;
    }
    const QRgb truth = *traced->truth.view().at(pixel->x(), pixel->y());
    QString text = u"<b>(%1, %2)</b> &nbsp;%3 &nbsp;"_s.arg(pixel->x())
                       .arg(pixel->y())
                       .arg(swatchHtml(*frame.at(pixel->x(), pixel->y())));
    if (m_model->isSomethingHidden()) {
        m_heading->setText(text + tr("what becomes of it is still ahead: predict it"));
        return;
    }
    const Difference difference = traced->differences.at(pixel->x(), pixel->y());
    const bool isDecided = traced->decidedAt(pixel->x(), pixel->y()) <= m_playhead->position();
    text += tr("truth %1").arg(swatchHtml(truth));
    if (isDecided && difference != Difference::None) {
        const Sign sign = signOf(difference);
        text += u" <b style='color:%1'>%2</b>"_s.arg(signColour(sign, palette()).name(),
                                                     signGlyph(sign));
    }
    m_heading->setText(text);
}

void PixelHistoryPanel::showReason(const QModelIndex &index)
{
    const QString reason = coreSentences(index.data(PixelHistoryModel::ReasonRole).toString());
    m_reason->setText(typesetHtml(reason));
    fitReason();
    setAccessibleDescription(reason);
}

void PixelHistoryPanel::goToWrite(const QModelIndex &index)
{
    const QVariant step = index.data(PixelHistoryModel::StepRole);
    if (step.isValid())
        m_playhead->seekToPixelStep(std::size_t(step.toULongLong()));
}

} // namespace pixelplumb
