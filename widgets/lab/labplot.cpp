// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labplot.h"

#include "widgets/look/appearance.h"
#include "widgets/studies/precisionscale.h"

#include <QBoxLayout>
#include <QBuffer>
#include <QEvent>
#include <QSvgGenerator>
#include <QToolTip>
#include <qcustomplot.h>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr QSize figureSize(960, 640); ///< logical pixels, captions included
constexpr int figureMargin = 16;
constexpr double figureRatio = 2; ///< of the picture's pixels to logical ones
constexpr double fewDecades = 3; ///< up to so many, 2 and 5 have ticks of their own

/// Figures are set in the program's font, which a person who opens them may not have.
int linesHeight(const QFont &font, const QStringList &lines, int width)
{
    return QFontMetrics(font)
        .boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, lines.join(u'\n'))
        .height();
}

} // namespace

LabPlot::LabPlot(const char *name, const QString &accessibleName, QWidget *parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot(this))
{
    setObjectName(QLatin1String(name));
    setAccessibleName(accessibleName);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setMinimumSize(minimumSizeHint());
    m_plot->setAutoAddPlottableToLegend(false);
    m_plot->setAntialiasedElements(QCP::aeAll);
    // Beside the curves, not over them.
    auto *beside = new QCPLayoutGrid;
    m_plot->plotLayout()->addElement(0, 1, beside);
    beside->addElement(0, 0, m_plot->legend);
    beside->addElement(1, 0, new QCPLayoutElement(m_plot));
    beside->setRowStretchFactor(0, 0.001);
    m_plot->plotLayout()->setColumnStretchFactor(1, 0.001);
    connect(m_plot, &QCustomPlot::mousePress, this,
            [this](QMouseEvent *event) { m_pressed = event->pos(); });
    connect(m_plot, &QCustomPlot::mouseRelease, this, [this](QMouseEvent *event) {
        const QPoint way = event->pos() - m_pressed;
        if (event->button() == Qt::LeftButton && way.manhattanLength() < 4)
            clickAt(event->position());
    });
    connect(m_plot, &QCustomPlot::mouseMove, this, [this](QMouseEvent *event) {
        const QString text = textAt(event->position());
        m_plot->setCursor(text.isEmpty() ? Qt::ArrowCursor : Qt::PointingHandCursor);
        QToolTip::showText(event->globalPosition().toPoint(), text, m_plot);
    });
}

QString LabPlot::textAt(const QPointF &) const { return {}; }

QCPLegend *LabPlot::legend() const { return m_plot->legend; }

QFont LabPlot::smallFont() const
{
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.9);
    return small;
}

void LabPlot::dress()
{
    const QColor text = palette().color(QPalette::Text);
    QColor faint = text;
    faint.setAlphaF(0.2F);
    m_plot->setBackground(QBrush(palette().color(QPalette::Base)));
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis, m_plot->xAxis2}) {
        axis->setBasePen(QPen(text));
        axis->setTickPen(QPen(text));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->setLabelPadding(2);
        axis->grid()->setPen(QPen(faint, 0, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(faint, 0, Qt::DotLine));
    }
    m_plot->legend->setBrush(QBrush(palette().color(QPalette::Base)));
    m_plot->legend->setBorderPen(Qt::NoPen);
    m_plot->legend->setTextColor(text);
    m_plot->legend->setFont(smallFont());
    m_plot->legend->setRowSpacing(0);
    m_plot->legend->setIconSize(24, 14);
}

void LabPlot::rebuild()
{
    m_plot->clearPlottables();
    m_plot->clearItems();
    dress();
    build();
    m_plot->legend->setVisible(m_plot->legend->itemCount() > 0);
    m_plot->replot();
}

void LabPlot::addMessage(const QString &text)
{
    auto *message = new QCPItemText(m_plot);
    message->setText(text);
    message->setFont(font());
    message->setColor(palette().color(QPalette::Text));
    message->setTextAlignment(Qt::AlignHCenter);
    message->setClipToAxisRect(false);
    message->position->setType(QCPItemPosition::ptAxisRectRatio);
    message->position->setCoords(0.5, 0.5);
}

QCPGraph *LabPlot::addKey(const QString &text)
{
    QCPGraph *key = m_plot->addGraph();
    key->setName(text);
    key->addToLegend();
    return key;
}

void LabPlot::setLogRange(QCPAxis *axis, double low, double high, const QString &prefix)
{
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setRange(low, high);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    const double decades = std::log10(high / low);
    const int stride = std::max(1, int(decades / 6));
    for (int exponent = int(std::floor(std::log10(low))); exponent <= std::log10(high);
         exponent += stride) {
        for (const int factor : {1, 2, 5}) {
            if (factor > 1 && decades > fewDecades)
                break;
            const double place = factor * std::pow(10.0, exponent);
            const bool isPlain = exponent >= -2 && exponent <= 4 && decades <= 2 * fewDecades;
            ticker->addTick(
                place,
                prefix + (isPlain ? QString::number(place, 'g', 6) : powerOfTenText(exponent)));
        }
    }
    axis->setTicker(ticker);
}

void LabPlot::asFigure(const std::function<void()> &paint)
{
    const QPalette window = palette();
    const bool isOwn = testAttribute(Qt::WA_SetPalette);
    const QRect place = m_plot->geometry();
    setPalette(lightPalette());
    paint();
    setPalette(isOwn ? window : QPalette());
    m_plot->setGeometry(place);
    rebuild();
}

void LabPlot::paintFigure(QCPPainter &painter, const QString &title, const QStringList &origin)
{
    const int width = figureSize.width() - 2 * figureMargin;
    QFont bold = font();
    bold.setBold(true);
    const int above = linesHeight(bold, {title}, width) + figureMargin / 2;
    const int below = linesHeight(smallFont(), origin, width) + figureMargin / 2;
    const int height = figureSize.height() - 2 * figureMargin - above - below;
    // Labels find their places in the size at hand.
    m_plot->setGeometry(0, 0, width, height);
    rebuild();
    painter.fillRect(QRect(QPoint(), figureSize), Qt::white);
    painter.setPen(Qt::black);
    painter.setFont(bold);
    painter.drawText(QRect(figureMargin, figureMargin, width, above), Qt::TextWordWrap, title);
    painter.setFont(smallFont());
    painter.drawText(QRect(figureMargin, figureSize.height() - figureMargin - below, width, below),
                     Qt::TextWordWrap | Qt::AlignBottom, origin.join(u'\n'));
    painter.translate(figureMargin, figureMargin + above);
    m_plot->toPainter(&painter, width, height);
}

QByteArray LabPlot::svg(const QString &title, const QStringList &origin)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    asFigure([&] {
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(figureSize);
        generator.setViewBox(QRect(QPoint(), figureSize));
        generator.setTitle(title);
        generator.setDescription(origin.join(u'\n'));
        QCPPainter painter(&generator);
        paintFigure(painter, title, origin);
    });
    return buffer.data();
}

QByteArray LabPlot::png(const QString &title, const QStringList &origin)
{
    QImage picture(figureSize * figureRatio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(figureRatio);
    asFigure([&] {
        QCPPainter painter(&picture);
        paintFigure(painter, title, origin);
    });
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return buffer.data();
}

void LabPlot::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    rebuild();
}

void LabPlot::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        rebuild();
    QWidget::changeEvent(event);
}

} // namespace pixelplumb
