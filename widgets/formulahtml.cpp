// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/formulahtml.h"

#include "widgets/blend.h"
#include "widgets/numberformat.h"
#include "widgets/symboltext.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

constexpr float quietShare = 0.38F; // keeps 4.5:1 on black and white
constexpr int comparedPlaces = 20; // more than a double has

constexpr std::array allSubjects
    = {FormulaSubject::General, FormulaSubject::LowerEdge, FormulaSubject::UpperEdge,
       FormulaSubject::Red,     FormulaSubject::Green,     FormulaSubject::Blue};

QString tr(const char *text) { return QCoreApplication::translate("FormulaPanel", text); }

QString titleOf(FormulaSubject subject)
{
    switch (subject) {
    case FormulaSubject::General:
        break;
    case FormulaSubject::LowerEdge:
        return tr("lower edge y_B");
    case FormulaSubject::UpperEdge:
        return tr("upper edge y_T");
    case FormulaSubject::Red:
        return tr("red R");
    case FormulaSubject::Green:
        return tr("green G");
    case FormulaSubject::Blue:
        return tr("blue B");
    }
    return tr("edges");
}

/// The two edges have their signs' colours. The channels keep the text's: red, green and blue are
/// not told apart by everybody, and their letters are.
QColor barColour(FormulaSubject subject, const QPalette &palette)
{
    if (subject == FormulaSubject::LowerEdge)
        return signColour(Sign::LowerEdge, palette);
    if (subject == FormulaSubject::UpperEdge)
        return signColour(Sign::UpperEdge, palette);
    return palette.color(QPalette::Mid);
}

/// True minus signs, and thin spaces that do not break in mixed numbers: "12 5/54".
QString typeset(QString text)
{
    static const QRegularExpression mixed(QStringLiteral("(\\d)[ \u2009](\\d+/\\d+)"));
    text.replace(mixed, QStringLiteral("\\1\u202f\\2"));
    static const QRegularExpression negative(QStringLiteral("(^|[^\\w⌋⌉)])-(?=\\d)"));
    return text.replace(negative, QStringLiteral("\\1−"));
}

/// Fractions are set smaller, so that 7 11/54 is not read as 711/54.
QString typesetHtml(const QString &text)
{
    static const QRegularExpression fraction(QStringLiteral("(?<![\\d)])(\\d+/\\d+)"));
    QString html = SymbolText(typeset(text)).html();
    return html.replace(fraction, QStringLiteral("<small>\\1</small>"));
}

/// Formulas without parentheses are short in every arithmetic: symbols and numbers share a line. By
/// the symbols, not by the numbers, so that a formula keeps its lines from step to step.
bool isShort(const FormulaLine &line) { return !line.symbols.contains(u'('); }

/// The number used, underlined from the first digit that the exact one does not have.
QString usedHtml(const FormulaLine &line, Arithmetic arithmetic)
{
    const QString text = displayText(line.used, arithmetic);
    const int marked = arithmetic == Arithmetic::Exact || line.exact.isNone()
        ? -1
        : firstDifferingDigit(text, displayDecimal(line.exact, comparedPlaces));
    if (marked < 0)
        return QStringLiteral("<b>%1</b>").arg(typesetHtml(text));
    return QStringLiteral("<b>%1<u>%2</u></b>").arg(text.left(marked), text.mid(marked));
}

QString exactText(const FormulaLine &line)
{
    QString text = tr("exact %1").arg(displayText(line.exact));
    if (!line.exact.isInteger() && line.exact.denominator() <= 999999)
        text += QStringLiteral(" = ") + displayDecimal(line.exact);
    return text;
}

QString errorText(const FormulaLine &line)
{
    return tr("error %1").arg(displayError(line.used, line.exact));
}

class HtmlWriter {
public:
    HtmlWriter(Arithmetic arithmetic, const QPalette &palette)
        : m_arithmetic(arithmetic)
        , m_palette(palette)
        , m_quiet(blended(palette.color(QPalette::Text), palette.color(QPalette::Base), quietShare)
                      .name())
    {
    }

    void begin(FormulaSubject subject)
    {
        m_bar = barColour(subject, m_palette).name();
        if (!m_html.isEmpty())
            m_html += QStringLiteral("<tr><td colspan='4' style='font-size:4px'>&nbsp;</td></tr>");
        row(QStringLiteral("<td colspan='2'><span style='color:%1'><b>%2</b></span></td>")
                .arg(subject == FormulaSubject::LowerEdge || subject == FormulaSubject::UpperEdge
                         ? m_bar
                         : m_palette.color(QPalette::Text).name(),
                     typesetHtml(titleOf(subject))));
    }

    void append(const FormulaLine &line)
    {
        const QString substituted = quiet(QStringLiteral("= ") + typesetHtml(line.substituted));
        QString symbols = typesetHtml(line.symbols);
        if (isShort(line))
            symbols += QStringLiteral(" &nbsp;") + substituted;
        row(QStringLiteral("<td>%1</td><td align='right'>%2</td>")
                .arg(symbols, usedHtml(line, m_arithmetic)));
        if (!isShort(line))
            row(QStringLiteral("<td colspan='2'>%1</td>").arg(substituted));
        if (m_arithmetic != Arithmetic::Exact && !line.used.isNone() && !line.exact.isNone())
            row(QStringLiteral("<td>%1</td><td align='right'>%2</td>")
                    .arg(quiet(typesetHtml(exactText(line))), quiet(errorText(line))));
    }

    QString html() const
    {
        return QStringLiteral("<table width='100%' cellspacing='0' cellpadding='1'>%1</table>")
            .arg(m_html);
    }

private:
    void row(const QString &cells)
    {
        m_html += QStringLiteral("<tr><td width='3' bgcolor='%1'></td><td width='8'></td>%2</tr>")
                      .arg(m_bar, cells);
    }

    QString quiet(const QString &html) const
    {
        return QStringLiteral("<span style='color:%1'>%2</span>").arg(m_quiet, html);
    }

    Arithmetic m_arithmetic;
    const QPalette &m_palette;
    QString m_quiet;
    QString m_bar;
    QString m_html;
};

} // namespace

QString formulaHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette)
{
    HtmlWriter writer(arithmetic, palette);
    for (const FormulaSubject subject : allSubjects) {
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
    return explanation.lines.empty() ? QString() : writer.html();
}

QString formulaText(const Explanation &explanation, Arithmetic arithmetic)
{
    QStringList lines;
    for (const FormulaLine &line : explanation.lines) {
        QString text = typeset(line.symbols).remove(u'_') + QStringLiteral(" = ")
            + typeset(line.substituted);
        if (!line.used.isNone())
            text += QStringLiteral(" = ") + displayText(line.used, arithmetic);
        if (arithmetic != Arithmetic::Exact && !line.used.isNone() && !line.exact.isNone())
            text += QStringLiteral("; ") + exactText(line) + QStringLiteral("; ") + errorText(line);
        lines.append(text);
    }
    return lines.join(u'\n');
}

QString sentenceHtml(const QString &sentence) { return typesetHtml(sentence); }

} // namespace pixelplumb
