// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/symboltext.h"

#include <QtWidgets>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr double subscriptSize = 0.75; // relative to the line's
constexpr double subscriptDrop = 0.18; // relative to the line's ascent

double pixelSizeOf(const QFont &font)
{
    return font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF();
}

} // namespace

SymbolText::SymbolText(const QString &text)
    : m_runs(symbolRuns(text))
{
}

QString SymbolText::html() const
{
    QString html;
    for (const SymbolRun &run : m_runs) {
        const QString text = run.text.toHtmlEscaped();
        html += run.level == SymbolRun::Level::Subscript ? u"<sub>%1</sub>"_s.arg(text) : text;
    }
    return html;
}

QFont SymbolText::fontFor(SymbolRun::Level level, const QFont &font)
{
    if (level == SymbolRun::Level::Line)
        return font;
    QFont smaller = font;
    const double size = pixelSizeOf(font) * subscriptSize;
    if (font.pixelSize() > 0)
        smaller.setPixelSize(qRound(size));
    else
        smaller.setPointSizeF(size);
    return smaller;
}

double SymbolText::width(const QFont &font) const
{
    double width = 0;
    for (const SymbolRun &run : m_runs)
        width += QFontMetricsF(fontFor(run.level, font)).horizontalAdvance(run.text);
    return width;
}

double SymbolText::draw(QPainter &painter, const QPointF &baseline, const QFont &font) const
{
    const double drop = QFontMetricsF(font).ascent() * subscriptDrop;
    QPointF position = baseline;
    for (const SymbolRun &run : m_runs) {
        const QFont runFont = fontFor(run.level, font);
        painter.setFont(runFont);
        painter.drawText(position + QPointF(0, run.level == SymbolRun::Level::Subscript ? drop : 0),
                         run.text);
        position.rx() += QFontMetricsF(runFont).horizontalAdvance(run.text);
    }
    return position.x() - baseline.x();
}

QString toolTipHtml(const QStringList &lines)
{
    QStringList html;
    for (const QString &line : lines)
        html += SymbolText(line).html();
    return u"<qt>%1</qt>"_s.arg(html.join(u"<br>"_s));
}

std::optional<Sign> edgeSignOf(const QString &symbol)
{
    if (symbol.contains(QLatin1String("_B")))
        return Sign::LowerEdge;
    if (symbol.contains(QLatin1String("_T")))
        return Sign::UpperEdge;
    return std::nullopt;
}

} // namespace pixelplumb
