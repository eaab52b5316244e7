// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labplot.h"

#include "widgets/lab/labtext.h"
#include "widgets/look/parts.h"
#include "widgets/studies/accuracy/precisionplot.h"

#include <QtWidgets>
#include <qcustomplot.h>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr double fewDecades = 3; ///< up to this many, 2 and 5 have ticks of their own
constexpr double mostDecades = 6; ///< up to this many, each has a number
constexpr int aroundAxis = 50; ///< for labels and margins beside an axis, logical pixels
constexpr double tickWidth = 45; ///< for a number on a horizontal axis, logical pixels
constexpr int lowHeight = 220; ///< logical pixels
constexpr QSize iconSize(24, 14); ///< of the legend, logical pixels
constexpr int besideIcon = 20; ///< the legend's paddings in a line, logical pixels
constexpr double legendShare = 0.4; ///< of the chart's width, at most

} // namespace

LabPlot::LabPlot(const char *name, const QString &accessibleName, QWidget *parent)
    : QWidget(parent)
    , m_plot(makePlot(this, [this](const QPointF &position) { clickAt(position); }))
{
    named(this, name, accessibleName);
    onEvents(this, {QEvent::Resize, QEvent::PaletteChange, QEvent::FontChange},
             [this] { rebuild(); });
    m_plot->setAutoAddPlottableToLegend(false);
    m_plot->setAntialiasedElements(QCP::aeAll);
    connect(m_plot, &QCustomPlot::mouseMove, this, [this](QMouseEvent *event) {
        const QString text = textAt(event->position());
        m_plot->setCursor(text.isEmpty() ? Qt::ArrowCursor : Qt::PointingHandCursor);
        QToolTip::showText(event->globalPosition().toPoint(),
                           text.isEmpty() ? keyTextAt(event->position()) : text, m_plot);
    });
}

QString LabPlot::textAt(const QPointF &) const { return {}; }

QString LabPlot::keyTextAt(const QPointF &position) const
{
    for (int i = 0; i < m_plot->legend->itemCount(); ++i) {
        auto *item = qobject_cast<QCPPlottableLegendItem *>(m_plot->legend->item(i));
        if (!item || !item->outerRect().contains(position.toPoint()))
            continue;
        const auto meaning = m_meanings.find(item->plottable());
        return meaning == m_meanings.end() ? QString() : meaning->second;
    }
    return {};
}

bool LabPlot::isLow() const { return m_plot->height() < lowHeight; }

QString LabPlot::titleOn(const SharedResults &results, const QString &family) const
{
    const StudyFamily *drawn = results ? results->family(family) : nullptr;
    return drawn ? tr("%1: %2").arg(accessibleName(), drawn->title) : accessibleName();
}

QFont LabPlot::smallFont() const
{
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.9);
    return small;
}

void LabPlot::rebuild()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_meanings.clear();
    dressPlot(*m_plot, *this);
    m_plot->legend->setFont(smallFont());
    m_plot->legend->setIconSize(iconSize);
    build();
    if (hasFocus() && !m_isOnPaper)
        frameFocus();
    layOut();
}

void LabPlot::layOut()
{
    fitLegend();
    m_plot->replot();
}

/// Arranges the legend in columns where it is higher than the chart; removes it where it would take
/// too much of the chart's width.
void LabPlot::fitLegend()
{
    QCPLegend *legend = m_plot->legend;
    const QFontMetrics metrics(smallFont());
    int widest = 0;
    for (int i = 0; i < legend->itemCount(); ++i) {
        if (auto *item = qobject_cast<QCPPlottableLegendItem *>(legend->item(i)))
            widest = std::max(widest, metrics.horizontalAdvance(item->plottable()->name()));
    }
    const int rows
        = std::max(1, m_plot->height() / std::max(iconSize.height(), metrics.height()) - 2);
    const int columns = (legend->itemCount() + rows - 1) / rows;
    if (columns * (iconSize.width() + besideIcon + widest) > legendShare * m_plot->width())
        legend->clearItems();
    legend->setWrap(rows);
    legend->setFillOrder(QCPLayoutGrid::foRowsFirst, true);
    legend->setVisible(legend->itemCount() > 0);
}

void LabPlot::frameFocus()
{
    auto *frame = new QCPItemRect(m_plot);
    frame->setPen(QPen(palette().color(QPalette::Highlight), 2));
    frame->setBrush(Qt::NoBrush);
    frame->setClipToAxisRect(false);
    for (QCPItemPosition *corner : {frame->topLeft, frame->bottomRight})
        corner->setType(QCPItemPosition::ptViewportRatio);
    frame->topLeft->setCoords(0, 0);
    frame->bottomRight->setCoords(1, 1);
}

void LabPlot::addMessage(const QString &text)
{
    auto *message = new QCPItemText(m_plot);
    message->setText(wrappedLines(text, font(), 0.8 * m_plot->width()).join(u'\n'));
    message->setFont(font());
    message->setColor(palette().color(QPalette::Text));
    message->setBrush(QBrush(palette().color(QPalette::Base)));
    message->setPadding({4, 2, 4, 2});
    message->setTextAlignment(Qt::AlignHCenter);
    message->setClipToAxisRect(false);
    message->position->setType(QCPItemPosition::ptAxisRectRatio);
    message->position->setCoords(0.5, 0.5);
}

void LabPlot::addKey(QCPAbstractPlottable *plottable, const QString &name, const QString &meaning)
{
    plottable->setName(name);
    plottable->addToLegend();
    m_meanings[plottable] = meaning;
}

QCPGraph *LabPlot::addKey(const QString &name, const QString &meaning)
{
    QCPGraph *key = m_plot->addGraph();
    addKey(key, name, meaning);
    return key;
}

void LabPlot::setLogRange(QCPAxis *axis, double low, double high, const QString &pattern) const
{
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setRange(low, high);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    const double decades = std::log10(high / low);
    const bool isAcross = axis->orientation() == Qt::Horizontal;
    const double most
        = std::max(2.0,
                   isAcross ? (m_plot->width() - aroundAxis) / tickWidth
                            : (m_plot->height() - aroundAxis) / double(2 * fontMetrics().height()));
    const bool isFine = decades <= fewDecades && 3 * decades <= most;
    const int stride = std::max(1, int(std::ceil(decades / std::min(most, mostDecades))));
    for (int exponent = int(std::floor(std::log10(low))); exponent <= std::log10(high);
         exponent += stride) {
        for (const int factor : {1, 2, 5}) {
            if (factor > 1 && !isFine)
                break;
            const double place = factor * std::pow(10.0, exponent);
            const bool isPlain = exponent >= -2 && exponent <= 4 && decades <= 2 * fewDecades;
            ticker->addTick(
                place,
                pattern.arg(isPlain ? QString::number(place, 'g', 6) : powerOfTenText(exponent)));
        }
    }
    axis->setTicker(ticker);
}

void LabPlot::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    rebuild();
}

void LabPlot::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    rebuild();
}

} // namespace pixelplumb
