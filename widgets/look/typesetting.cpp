// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/typesetting.h"

#include "core/grade/showntext.h"
#include "core/scene/text/shortened.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/symboltext.h"

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

} // namespace pixelplumb
