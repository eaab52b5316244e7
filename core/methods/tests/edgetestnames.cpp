// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/edgetestnames.h"

#include "core/scan/tests/edgetestsetup.h"

#include <QStringList>

#include <array>

namespace pixelplumb {

namespace {

constexpr std::array<char16_t, 3> digits = {u'₀', u'₁', u'₂'};
constexpr std::array<char16_t, 3> weights = {u'α', u'β', u'γ'};
constexpr std::array<char16_t, 3> cramerWeights = {u'u', u'v', u'w'};

QString weightId(const EdgeTestForm &form, std::size_t line)
{
    constexpr std::array names = {"alpha", "beta", "gamma"};
    return form.inside == InsideTest::Cramer ? QString(QChar(cramerWeights[line]))
                                             : QString::fromLatin1(names[line]);
}

QString lineId(const EdgeTestForm &form, std::size_t line)
{
    constexpr std::array names = {"_bc", "_ca", "_ab"};
    return form.isBarycentric() ? QString::fromLatin1(names[line])
                                : QStringLiteral("_%1").arg(line);
}

} // namespace

QString EdgeTestNames::vertex(std::size_t vertex) const
{
    return m_form.isBarycentric() ? vertexId(vertex) : QString(QChar(digits[vertex]));
}

QString EdgeTestNames::vertexId(std::size_t vertex) const
{
    if (!m_form.isBarycentric())
        return QStringLiteral("_%1").arg(vertex);
    const QChar first = m_form.inside == InsideTest::Cramer ? u'A' : u'a';
    return QStringLiteral("_") + QChar(char16_t(first.unicode() + vertex));
}

QString EdgeTestNames::vertexLetter(std::size_t vertex) const
{
    return m_form.isBarycentric() ? vertexId(vertex).sliced(1)
                                  : QStringLiteral("P") + digits[vertex];
}

QString EdgeTestNames::vertexName(std::size_t vertex) const
{
    return m_form.isBarycentric()
        ? QStringLiteral("%1 = P%2").arg(vertexLetter(vertex)).arg(QChar(digits[vertex]))
        : vertexLetter(vertex);
}

QString EdgeTestNames::weight(std::size_t line) const
{
    return QChar(m_form.inside == InsideTest::Cramer ? cramerWeights[line] : weights[line]);
}

QString EdgeTestNames::filled(QString text, std::size_t line) const
{
    const EdgeEnds ends = edgeEndsOf(m_form, line);
    text.replace(QStringLiteral("{edge}"), vertexLetter(ends.from) + vertexLetter(ends.to));
    text.replace(QStringLiteral("{facing}"), vertexName(ends.opposite));
    text.replace(QStringLiteral("{letter}"), vertexLetter(ends.opposite));
    text.replace(QStringLiteral("{value}"),
                 m_form.isBarycentric() ? QStringLiteral("f{l}") : QStringLiteral("E{l}"));
    text.replace(QStringLiteral("{l}"),
                 m_form.isBarycentric() ? lineId(m_form, line) : QString(QChar(digits[line])));
    text.replace(QStringLiteral("{w}"), weight(line));
    text.replace(QStringLiteral("{from}"), vertex(ends.from));
    text.replace(QStringLiteral("{to}"), vertex(ends.to));
    return text.replace(QStringLiteral("{opp}"), vertex(ends.opposite));
}

QString EdgeTestNames::filledId(QString text, std::size_t line) const
{
    text.replace(QStringLiteral("{value}"),
                 m_form.isBarycentric() ? QStringLiteral("f{l}") : QStringLiteral("E{l}"));
    text.replace(QStringLiteral("{l}"), lineId(m_form, line));
    text.replace(QStringLiteral("{opp}"), vertexId(edgeEndsOf(m_form, line).opposite));
    return text.replace(QStringLiteral("{w}"), weightId(m_form, line));
}

QString EdgeTestNames::lineAt(const QString &x, const QString &y) const
{
    switch (m_form.line) {
    case LineForm::Absolute:
    case LineForm::Solved:
    case LineForm::CommonVertex:
        break;
    case LineForm::CanonicalEnd:
        return QStringLiteral("a{l}·(%1 − u{l}) + b{l}·(%2 − v{l})").arg(x, y);
    case LineForm::FirstEnd:
        return QStringLiteral("a{l}·(%1 − x{from}) + b{l}·(%2 − y{from})").arg(x, y);
    }
    return QStringLiteral("a{l}·%1 + b{l}·%2 + c{l}").arg(x, y);
}

QString EdgeTestNames::linesText() const
{
    if (m_form.inside == InsideTest::Cramer)
        return QStringLiteral("D ← x_AC·y_BC − x_BC·y_AC — the determinant");
    const QString edges = m_form.isBarycentric() ? QStringLiteral("f_bc, f_ca, f_ab")
                                                 : QStringLiteral("E₀, E₁, E₂");
    switch (m_form.line) {
    case LineForm::Absolute:
    case LineForm::CommonVertex:
        break;
    case LineForm::Solved:
        return edges
            + QStringLiteral(": A and B solved from the two ends of the edge with C = −1, or with "
                             "C = 0 where its line passes through (0, 0)");
    case LineForm::CanonicalEnd:
        return edges + QStringLiteral(": a and b counted from the end that is smaller in (x, y)");
    case LineForm::FirstEnd:
        return edges + QStringLiteral(": a and b counted from the first end of the edge");
    }
    return edges + QStringLiteral(": a, b, c from the two ends of the edge");
}

QString EdgeTestNames::weightFormula(std::size_t line) const
{
    if (m_form.inside == InsideTest::Cramer) {
        const std::array formulas = {"u = ((x − x_C)·y_BC − x_BC·(y − y_C))/D",
                                     "v = (x_AC·(y − y_C) − (x − x_C)·y_AC)/D", "w = 1 − u − v"};
        return formulas[line];
    }
    if (m_form.evaluation == Evaluation::Increments)
        return filled("{w} ← {w}′ + Δ{w}_y", line);
    return filled("{w} = f{l}/f{opp}", line);
}

QString EdgeTestNames::levelFormula() const
{
    if (!m_form.isBarycentric())
        return QStringLiteral("% = E₀/F₀·%₂ + E₁/F₁·%₀ + E₂/F₂·%₁");
    if (m_form.inside == InsideTest::Cramer)
        return QStringLiteral("% = u·%_A + v·%_B + w·%_C");
    if (m_form.evaluation == Evaluation::Increments)
        return QStringLiteral("% ← %′ + Δ%_y");
    return QStringLiteral("% = α·%_a + β·%_b + γ·%_c");
}

QString EdgeTestNames::tieText(FillRule rule) const
{
    return rule == FillRule::OffScreenPoint ? QStringLiteral("{value}({letter})·{value}(r) > 0")
                                            : QStringLiteral("tie{l} = 1");
}

QString EdgeTestNames::cramerText(FillRule rule) const
{
    if (rule == FillRule::Closed)
        return QStringLiteral("if u ≥ 0 and v ≥ 0 and u + v ≤ 1:");
    if (rule == FillRule::Open)
        return QStringLiteral("if u > 0 and v > 0 and u + v < 1:");
    constexpr std::array inside
        = {u"u > 0, or u = 0", u"v > 0, or v = 0", u"u + v < 1, or u + v = 1"};
    QStringList tests;
    for (std::size_t line = 0; line < 3; ++line)
        tests.append(QString::fromUtf16(inside[line]) + QStringLiteral(" and ")
                     + filled(tieText(rule), line));
    return QStringLiteral("if ") + tests.join(QStringLiteral("; ")) + u':';
}

} // namespace pixelplumb
