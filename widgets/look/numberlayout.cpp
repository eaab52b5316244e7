// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/numberlayout.h"

#include "widgets/look/numberformat.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double fractionSize = 0.86; // relative to the line's

QFont fractionFont(QFont font)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * fractionSize));
    else
        font.setPointSizeF(font.pointSizeF() * fractionSize);
    return font;
}

} // namespace

NumberParts partsOf(const QString &displayText)
{
    const qsizetype slash = displayText.indexOf(u'/');
    if (slash >= 0) {
        const qsizetype space = displayText.indexOf(thinSpace);
        const bool isNegative = displayText.startsWith(QChar(0x2212));
        const qsizetype start = space >= 0 ? space + 1 : qsizetype(isNegative);
        const qsizetype wholeEnd = space >= 0 ? space : start;
        return {displayText.left(wholeEnd),
                displayText.mid(start, slash - start),
                displayText.mid(slash + 1),
                {}};
    }
    const qsizetype point = displayText.indexOf(u'.');
    if (point < 0)
        return {displayText, {}, {}, {}};
    return {displayText.left(point), {}, {}, displayText.mid(point)};
}

double NumberLayout::tailWidth() const
{
    return std::max(m_denominator > 0 ? fractionWidth() : 0.0, m_decimals);
}

void NumberLayout::include(const QString &displayText, const QFont &font)
{
    const QFontMetricsF metrics(font);
    const NumberParts parts = partsOf(displayText);
    m_whole = std::max(m_whole, metrics.horizontalAdvance(parts.whole));
    m_decimals = std::max(m_decimals, metrics.horizontalAdvance(parts.decimals));
    if (parts.denominator.isEmpty())
        return;
    const QFontMetricsF smaller(fractionFont(font));
    m_gap = smaller.horizontalAdvance(u'0') / 2;
    m_slash = smaller.horizontalAdvance(u'/');
    m_denominator = std::max(m_denominator, smaller.horizontalAdvance(parts.denominator));
    m_numerator = std::max(m_numerator, m_denominator);
}

void NumberLayout::draw(QPainter &painter, const QRectF &rect, const QString &displayText,
                        int marked) const
{
    const QFont font = painter.font();
    const QFontMetricsF metrics(font);
    const QFontMetricsF smaller(fractionFont(font));
    const double baseline = rect.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    qsizetype drawn = 0;
    const auto drawPart = [&](double x, const QString &part) {
        painter.drawText(QPointF(x, baseline), part);
        const qsizetype firstMarked = std::max<qsizetype>(0, marked - drawn);
        if (marked >= 0 && firstMarked < part.size()) {
            const double from = x + metrics.horizontalAdvance(part.left(firstMarked));
            const double to = x + metrics.horizontalAdvance(part);
            const double y = baseline + metrics.descent() * 0.6;
            painter.drawLine(QPointF(from, y), QPointF(to, y));
        }
        drawn += part.size();
    };
    const NumberParts parts = partsOf(displayText);
    const double wholeWidth = metrics.horizontalAdvance(parts.whole);
    const double split = rect.right() - tailWidth();
    const bool isSignAlone = parts.whole.size() == 1 && !parts.whole.front().isDigit();
    const double wholeEnd = isSignAlone && !parts.numerator.isEmpty()
        ? split + m_gap + m_numerator - smaller.horizontalAdvance(parts.numerator)
        : split;
    drawPart(wholeEnd - wholeWidth, parts.whole);
    if (!parts.decimals.isEmpty())
        drawPart(split, parts.decimals);
    if (parts.denominator.isEmpty())
        return;
    const double slash = split + m_gap + m_numerator;
    painter.setFont(fractionFont(font));
    const auto drawSmaller
        = [&](double x, const QString &part) { painter.drawText(QPointF(x, baseline), part); };
    drawSmaller(slash - smaller.horizontalAdvance(parts.numerator), parts.numerator);
    drawSmaller(slash, u"/"_s);
    drawSmaller(slash + m_slash, parts.denominator);
    painter.setFont(font);
}

} // namespace pixelplumb
