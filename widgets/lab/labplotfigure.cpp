// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labplot.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/appearance.h"

#include <QBuffer>
#include <QSvgGenerator>
#include <qcustomplot.h>

namespace pixelplumb {

namespace {

constexpr QSize figureSize(960, 640); ///< logical pixels, with captions
constexpr int figureMargin = 16;
constexpr double figureRatio = 2; ///< picture pixels per logical one

/// Lines of text, one below the other, wrapped to the figure's width.
class Caption {
public:
    Caption(const QStringList &paragraphs, const QFont &font)
        : m_font(font)
    {
        for (const QString &paragraph : paragraphs)
            m_lines += wrappedLines(paragraph, font, figureSize.width() - 2 * figureMargin);
    }

    int height() const { return int(m_lines.size()) * QFontMetrics(m_font).lineSpacing(); }
    void paint(QPainter &painter, int top) const
    {
        const QFontMetrics metrics(m_font);
        painter.setFont(m_font);
        painter.setPen(Qt::black);
        for (qsizetype i = 0; i < m_lines.size(); ++i) {
            const int baseline = top + metrics.ascent() + int(i) * metrics.lineSpacing();
            painter.drawText(QPoint(figureMargin, baseline), m_lines[i]);
        }
    }

private:
    QFont m_font;
    QStringList m_lines;
};

} // namespace

void LabPlot::asFigure(const std::function<void()> &paint)
{
    const QPalette window = palette();
    const bool isOwn = testAttribute(Qt::WA_SetPalette);
    const QRect place = m_plot->geometry();
    m_isOnPaper = true;
    setPalette(lightPalette());
    paint();
    m_isOnPaper = false;
    setPalette(isOwn ? window : QPalette());
    m_plot->setGeometry(place);
    rebuild();
}

QFont LabPlot::titleFont() const { return bold(font()); }

void LabPlot::paintFigure(QCPPainter &painter, const QStringList &origin)
{
    const Caption title({figureTitle()}, titleFont());
    const Caption below(origin, smallFont());
    const int top = figureMargin + title.height() + figureMargin / 2;
    const int bottom = figureSize.height() - figureMargin - below.height();
    const int width = figureSize.width() - 2 * figureMargin;
    const int height = bottom - figureMargin / 2 - top;
    // Labels depend on the current size.
    m_plot->setGeometry(0, 0, width, height);
    rebuild();
    painter.fillRect(QRect(QPoint(), figureSize), Qt::white);
    title.paint(painter, figureMargin);
    below.paint(painter, bottom);
    painter.translate(figureMargin, top);
    m_plot->toPainter(&painter, width, height);
}

QByteArray LabPlot::svg(const QStringList &origin)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    asFigure([&] {
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(figureSize);
        generator.setViewBox(QRect(QPoint(), figureSize));
        generator.setTitle(figureTitle());
        generator.setDescription(origin.join(u'\n'));
        QCPPainter painter(&generator);
        paintFigure(painter, origin);
    });
    return buffer.data();
}

QByteArray LabPlot::png(const QStringList &origin)
{
    QImage picture(figureSize * figureRatio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(figureRatio);
    asFigure([&] {
        QCPPainter painter(&picture);
        paintFigure(painter, origin);
    });
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return buffer.data();
}

} // namespace pixelplumb
