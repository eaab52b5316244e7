// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/typesetting.h"

#include "core/grade/showntext.h"
#include "core/scene/text/shortened.h"
#include "widgets/look/numberformat.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

struct NumberToolTip {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::NumberToolTip)
};

void appendDecimal(QStringList &lines, const Quantity &quantity, Arithmetic arithmetic)
{
    if (const QString decimal = decimalBeside(quantity, arithmetic); !decimal.isEmpty())
        lines.append(decimal);
}

/// Replaces the channel's letter by C: in "ΔR", but not the right bound in "x_R".
QString withoutChannel(QString symbols, QChar channel)
{
    const QRegularExpression letter(u"(?<![A-Za-z_])%1(?![A-Za-z])"_s.arg(channel));
    return symbols.replace(letter, u"C"_s);
}

constexpr double subscriptSize = 0.75; // relative to the line's
constexpr double subscriptDrop = 0.18; // relative to the line's ascent

double pixelSizeOf(const QFont &font)
{
    return font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF();
}

} // namespace

QString typeset(QString text)
{
    static const QRegularExpression mixed(u"(\\d)[ \u2009](\\d+/\\d+)"_s);
    text.replace(mixed, u"\\1\u202f\\2"_s);
    static const QRegularExpression negative(u"(^|[^\\w⌋⌉)])-(?=\\d)"_s);
    return text.replace(negative, u"\\1−"_s);
}

QString typesetHtml(const QString &text)
{
    static const QRegularExpression fraction(u"(?<![\\d).])(\\d+/\\d+)(?!\\d|\\.\\d)"_s);
    // Rich text turns every space except the no-break space into an ordinary one, at which a line
    // may break, as it may at an exponent's sign.
    static const QRegularExpression exponent(u"(\\de)([-−+])(?=\\d)"_s);
    QString whole = typeset(text).replace(u'\u202f', QChar::Nbsp);
    whole.replace(u"else "_s, u"else\u00a0"_s);
    whole.replace(exponent, u"\\1\u2060\\2\u2060"_s);
    QString html = SymbolText(whole).html();
    return html.replace(fraction, u"<small>\\1</small>"_s);
}

QString shownName(const QString &path)
{
    constexpr qsizetype longestName = 120; // characters
    return escapedControls(shortened(QFileInfo(path).fileName(), longestName));
}

QString withoutMarkup(QString symbols) { return symbols.remove(u'_'); }

QString numberToolTip(const NumberDescription &number)
{
    QStringList lines(number.toolTip);
    if (!number.formula.isEmpty())
        lines.append(number.formula);
    if (!number.unit.isEmpty())
        lines.append(NumberToolTip::tr("unit: %1").arg(number.unit));
    return toolTipHtml(lines);
}

QString numberToolTip(const NumberDescription &number, const Quantity &used, const Quantity &exact,
                      Arithmetic arithmetic)
{
    QStringList lines(number.title + u" = "_s + displayText(used, arithmetic)
                      + (number.unit.isEmpty() ? QString() : u' ' + number.unit));
    appendDecimal(lines, used, arithmetic);
    if (!exact.isNone()) {
        lines.append(NumberToolTip::tr("exact %1").arg(displayText(exact)));
        appendDecimal(lines, exact, Arithmetic::Exact);
        lines.append(NumberToolTip::tr("error %1").arg(displayError(used, exact)));
    }
    lines.append(number.toolTip);
    if (!number.formula.isEmpty())
        lines.append(number.formula);
    return toolTipHtml(lines);
}

std::optional<QChar> channelOf(const FormulaLine &line)
{
    switch (line.subject) {
    case NumberSubject::Red:
        return u'R';
    case NumberSubject::Green:
        return u'G';
    case NumberSubject::Blue:
        return u'B';
    default:
        return std::nullopt;
    }
}

std::vector<ChannelFormula> channelFormulas(std::span<const FormulaLine> lines)
{
    std::vector<ChannelFormula> formulas;
    for (const FormulaLine &line : lines) {
        const std::optional<QChar> channel = channelOf(line);
        if (!channel)
            continue;
        const QString symbols = withoutChannel(line.symbols, *channel);
        const auto isOpen = [&](const ChannelFormula &formula) {
            return formula.symbols == symbols
                && std::ranges::none_of(formula.lines, [&](const FormulaLine *other) {
                       return other->subject == line.subject;
                   });
        };
        const auto formula = std::ranges::find_if(formulas, isOpen);
        if (formula == formulas.end())
            formulas.push_back({symbols, {&line}});
        else
            formula->lines.push_back(&line);
    }
    return formulas;
}

using namespace Qt::StringLiterals;

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
