// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/formulahtml.h"

#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/signs.h"
#include "widgets/look/typesetting.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <utility>

namespace pixelplumb {

namespace {

constexpr float quietShare = 0.38F; // keeps 4.5:1 on black and white
/// Lines may break within longer numbers, which would not fit into a panel.
constexpr qsizetype mostUnbroken = 26; // characters: a double's with sign and exponent

constexpr std::array otherSubjects
    = {NumberSubject::General, NumberSubject::LowerEdge, NumberSubject::UpperEdge,
       NumberSubject::LeftEdge, NumberSubject::RightEdge};

struct FormulaHtml {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::FormulaHtml)
};

QString titleOf(NumberSubject subject)
{
    if (subject == NumberSubject::LowerEdge)
        return FormulaHtml::tr("smaller-y edge");
    if (subject == NumberSubject::UpperEdge)
        return FormulaHtml::tr("larger-y edge");
    if (subject == NumberSubject::LeftEdge)
        return FormulaHtml::tr("left edge");
    if (subject == NumberSubject::RightEdge)
        return FormulaHtml::tr("right edge");
    return {};
}

/// The two edges have their signs' colours. The channels keep the text's: not everybody can tell
/// red, green and blue apart, but their letters differ.
QColor barColour(NumberSubject subject, const QPalette &palette)
{
    if (subject == NumberSubject::LowerEdge || subject == NumberSubject::LeftEdge)
        return signColour(Sign::LowerEdge, palette);
    if (subject == NumberSubject::UpperEdge || subject == NumberSubject::RightEdge)
        return signColour(Sign::UpperEdge, palette);
    return palette.color(QPalette::Mid);
}

/// Whether symbols and numbers share a line: formulas without parentheses are short in every
/// arithmetic. The symbols decide, not the numbers, so that a formula keeps its layout from step to
/// step.
bool isShort(const FormulaLine &line) { return !line.symbols.contains(u'('); }

/// Whether the exact number and the error are shown beside a number: where it may be rounded.
bool isCompared(const FormulaLine &line, Arithmetic arithmetic)
{
    const bool isRounded = arithmetic != Arithmetic::Exact || !line.used.isRational();
    return isRounded && !line.used.isNone() && !line.exact.isNone();
}

/// Whether nothing was lost: the exact number then needs no line of its own.
bool isSameAsExact(const FormulaLine &line)
{
    return displayError(line.used, line.exact) == u"0"_s;
}

/// The number used, underlined from the first digit that differs from the exact one.
QString usedHtml(const FormulaLine &line, Arithmetic arithmetic)
{
    const QString text = displayText(line.used, arithmetic);
    const int marked = !isCompared(line, arithmetic)
        ? -1
        : firstDifferingDigit(text, displayDecimal(line.exact, comparedPlaces));
    if (marked < 0)
        return u"<b>%1</b>"_s.arg(typesetHtml(text));
    return u"<b>%1<u>%2</u></b>"_s.arg(typesetHtml(text.left(marked)),
                                       typesetHtml(text.mid(marked)));
}

QString exactText(const FormulaLine &line)
{
    QString text = FormulaHtml::tr("exact %1").arg(displayText(line.exact));
    if (!line.exact.isInteger() && line.exact.denominator() <= 999999)
        text += u" = "_s + displayDecimal(line.exact);
    return text;
}

QString errorText(const FormulaLine &line)
{
    return FormulaHtml::tr("error %1").arg(displayError(line.used, line.exact));
}

/// The symbols of a formula, which may name in words what it computes: "first row = ⌈y_B⌉".
QString shownSymbols(const QString &symbols)
{
    static const QRegularExpression named(u"^([a-z]+ [A-Za-z]+)(?= [=←] )"_s);
    return typesetHtml(QString(symbols).replace(named, coreWord(named.match(symbols).captured())));
}

class HtmlWriter {
public:
    HtmlWriter(Arithmetic arithmetic, const QPalette &palette,
               ChannelSymbols symbols = ChannelSymbols::Above)
        : m_arithmetic(arithmetic)
        , m_symbols(symbols)
        , m_palette(palette)
        , m_quiet(blended(palette.color(QPalette::Text), palette.color(QPalette::Base), quietShare)
                      .name())
    {
    }

    void begin(NumberSubject subject)
    {
        m_bar = barColour(subject, m_palette).name();
        m_title = titleOf(subject);
        if (!m_html.isEmpty())
            m_html += u"<tr><td colspan='5' style='font-size:3px'>&nbsp;</td></tr>"_s;
    }

    /// Begins a stage with its heading.
    void begin(const StageFormulas &stage)
    {
        begin(NumberSubject::General);
        const QString note = stage.note.isEmpty() ? QString() : u": "_s + stage.note;
        row(wide(u"<b>%1</b>"_s.arg(typesetHtml(stage.stage + u", "_s + stage.point + note))));
    }

    void append(const FormulaLine &line)
    {
        QString symbols = takeTitle() + shownSymbols(line.symbols);
        const bool isGiven = line.substituted.isEmpty();
        const bool sharesLine = isGiven || line.subject != NumberSubject::General || isShort(line);
        if (sharesLine && !isGiven)
            symbols += u" &nbsp;"_s + quiet(equals(line));
        row(wide(symbols) + used(line));
        if (!sharesLine)
            row(wide(quiet(equals(line))));
        compare(line);
    }

    /// Appends the symbols once, beside the channels' rows where they are short, else above them.
    void append(const ChannelFormula &formula)
    {
        const auto place = isShort(*formula.lines.front()) ? m_symbols : ChannelSymbols::Above;
        const bool isBeside = place == ChannelSymbols::Beside;
        QString symbols = shownSymbols(formula.symbols);
        if (!isBeside)
            row(wide(symbols));
        for (const FormulaLine *line : formula.lines) {
            const QString channel = u"%1 &nbsp;%2"_s.arg(channelOf(*line).value_or(QChar()))
                                        .arg(quiet(equals(*line)));
            row((isBeside ? beside(std::exchange(symbols, {}), channel) : wide(channel))
                + used(*line));
            compare(*line, place);
        }
    }

    QString html() const
    {
        return u"<table width='100%' cellspacing='0' cellpadding='0'>%1</table>"_s.arg(m_html);
    }

private:
    /// The group's title, for its first line only.
    QString takeTitle()
    {
        const QString title = std::exchange(m_title, QString());
        return title.isEmpty()
            ? title
            : u"<span style='color:%1'><b>%2</b></span> &nbsp;"_s.arg(m_bar, title);
    }

    static QString equals(const FormulaLine &line)
    {
        return u"= "_s + typesetHtml(line.substituted);
    }

    static QString wide(const QString &html) { return u"<td colspan='2'>%1</td>"_s.arg(html); }

    /// Two cells; the first is as wide as its text.
    static QString beside(const QString &symbols, const QString &html)
    {
        return u"<td width='1'>%1</td><td>%2</td>"_s.arg(
            unbroken(symbols.isEmpty() ? symbols : symbols + u" &nbsp;"_s), html);
    }

    static QString unbroken(const QString &html)
    {
        return u"<p style='white-space:nowrap; margin:0'>%1</p>"_s.arg(html);
    }

    QString used(const FormulaLine &line) const
    {
        const bool isSame = isCompared(line, m_arithmetic) && isSameAsExact(line);
        const QString html = isSame
            ? quiet(FormulaHtml::tr("exact")) + u"&nbsp; "_s + usedHtml(line, m_arithmetic)
            : usedHtml(line, m_arithmetic);
        const bool isWhole = displayText(line.used, m_arithmetic).size() <= mostUnbroken;
        const QString width = isWhole ? u"width='1'"_s : QString(); // as its text
        return u"<td align='right' style='padding-left:12px' %1>%2</td>"_s.arg(
            width, isWhole ? unbroken(html) : html);
    }

    /// Adds the exact number and the error, where the arithmetic has rounded.
    void compare(const FormulaLine &line, ChannelSymbols symbols = ChannelSymbols::Above)
    {
        if (!isCompared(line, m_arithmetic) || isSameAsExact(line))
            return;
        const QString exact = u"&nbsp; &nbsp; "_s + quiet(typesetHtml(exactText(line)));
        row((symbols == ChannelSymbols::Beside ? beside({}, exact) : wide(exact))
            + u"<td align='right'>%1</td>"_s.arg(unbroken(quiet(typesetHtml(errorText(line))))));
    }

    void row(const QString &cells)
    {
        m_html += u"<tr><td width='3' bgcolor='%1'></td><td width='8'></td>%2</tr>"_s.arg(m_bar,
                                                                                          cells);
    }

    QString quiet(const QString &html) const
    {
        return u"<span style='color:%1'>%2</span>"_s.arg(m_quiet, html);
    }

    Arithmetic m_arithmetic;
    ChannelSymbols m_symbols;
    const QPalette &m_palette;
    QString m_quiet;
    QString m_bar;
    QString m_title;
    QString m_html;
};

} // namespace

QString formulaHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette,
                    ChannelSymbols symbols)
{
    HtmlWriter writer(arithmetic, palette, symbols);
    for (const NumberSubject subject : otherSubjects) {
        bool hasBegun = false;
        for (const FormulaLine &line : explanation.lines) {
            if (line.subject != subject)
                continue;
            if (!hasBegun)
                writer.begin(subject);
            hasBegun = true;
            writer.append(line);
        }
    }
    const std::vector<ChannelFormula> colours = channelFormulas(explanation.lines);
    if (!colours.empty())
        writer.begin(NumberSubject::Red);
    for (const ChannelFormula &formula : colours)
        writer.append(formula);
    return explanation.lines.empty() ? QString() : writer.html();
}

QString stagesHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette)
{
    HtmlWriter writer(arithmetic, palette);
    for (const StageFormulas &stage : explanation.stages) {
        writer.begin(stage);
        for (const FormulaLine &line : stage.lines)
            writer.append(line);
    }
    return explanation.stages.empty() ? QString() : writer.html();
}

QString formulaText(const Explanation &explanation, Arithmetic arithmetic)
{
    QStringList lines;
    const auto append = [&](const FormulaLine &line) {
        QString text = typeset(line.symbols).remove(u'_');
        if (!line.substituted.isEmpty())
            text += u" = "_s + typeset(line.substituted);
        if (!line.used.isNone())
            text += u" = "_s + displayText(line.used, arithmetic);
        if (isCompared(line, arithmetic))
            text += u"; "_s + exactText(line) + u"; "_s + errorText(line);
        lines.append(text);
    };
    for (const FormulaLine &line : explanation.lines)
        append(line);
    for (const StageFormulas &stage : explanation.stages) {
        lines.append(stage.stage + u", "_s + stage.point);
        for (const FormulaLine &line : stage.lines)
            append(line);
    }
    return lines.join(u'\n');
}

} // namespace pixelplumb
