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
    return form.isBarycentric() ? QString::fromLatin1(names[line]) : u"_%1"_s.arg(line);
}

} // namespace

QString EdgeTestNames::vertex(std::size_t vertex) const
{
    return m_form.isBarycentric() ? vertexId(vertex) : QString(QChar(digits[vertex]));
}

QString EdgeTestNames::vertexId(std::size_t vertex) const
{
    if (!m_form.isBarycentric())
        return u"_%1"_s.arg(vertex);
    const QChar first = m_form.inside == InsideTest::Cramer ? u'A' : u'a';
    return u"_"_s + QChar(char16_t(first.unicode() + vertex));
}

QString EdgeTestNames::vertexLetter(std::size_t vertex) const
{
    return m_form.isBarycentric() ? vertexId(vertex).sliced(1) : u"P"_s + digits[vertex];
}

QString EdgeTestNames::vertexName(std::size_t vertex) const
{
    return m_form.isBarycentric()
        ? u"%1 = P%2"_s.arg(vertexLetter(vertex)).arg(QChar(digits[vertex]))
        : vertexLetter(vertex);
}

QString EdgeTestNames::weight(std::size_t line) const
{
    return QChar(m_form.inside == InsideTest::Cramer ? cramerWeights[line] : weights[line]);
}

QString EdgeTestNames::filled(QString text, std::size_t line) const
{
    const EdgeEnds ends = edgeEndsOf(m_form, line);
    text.replace(u"{edge}"_s, vertexLetter(ends.from) + vertexLetter(ends.to));
    text.replace(u"{facing}"_s, vertexName(ends.opposite));
    text.replace(u"{letter}"_s, vertexLetter(ends.opposite));
    text.replace(u"{value}"_s, m_form.isBarycentric() ? u"f{l}"_s : u"E{l}"_s);
    text.replace(u"{l}"_s,
                 m_form.isBarycentric() ? lineId(m_form, line) : QString(QChar(digits[line])));
    text.replace(u"{w}"_s, weight(line));
    text.replace(u"{from}"_s, vertex(ends.from));
    text.replace(u"{to}"_s, vertex(ends.to));
    return text.replace(u"{opp}"_s, vertex(ends.opposite));
}

QString EdgeTestNames::filledId(QString text, std::size_t line) const
{
    text.replace(u"{value}"_s, m_form.isBarycentric() ? u"f{l}"_s : u"E{l}"_s);
    text.replace(u"{l}"_s, lineId(m_form, line));
    text.replace(u"{opp}"_s, vertexId(edgeEndsOf(m_form, line).opposite));
    return text.replace(u"{w}"_s, weightId(m_form, line));
}

QString EdgeTestNames::lineAt(const QString &x, const QString &y) const
{
    switch (m_form.line) {
    case LineForm::Absolute:
    case LineForm::Solved:
    case LineForm::CommonVertex:
        break;
    case LineForm::CanonicalEnd:
        return u"a{l}·(%1 − u{l}) + b{l}·(%2 − v{l})"_s.arg(x, y);
    case LineForm::FirstEnd:
        return u"a{l}·(%1 − x{from}) + b{l}·(%2 − y{from})"_s.arg(x, y);
    }
    return u"a{l}·%1 + b{l}·%2 + c{l}"_s.arg(x, y);
}

QString EdgeTestNames::linesText() const
{
    if (m_form.inside == InsideTest::Cramer)
        return u"D ← x_AC·y_BC − x_BC·y_AC — the determinant"_s;
    const QString edges = m_form.isBarycentric() ? u"f_bc, f_ca, f_ab"_s : u"E₀, E₁, E₂"_s;
    switch (m_form.line) {
    case LineForm::Absolute:
    case LineForm::CommonVertex:
        break;
    case LineForm::Solved:
        return edges
            + u": A and B solved from the two ends of the edge with C = −1, or with "
              "C = 0 where its line passes through (0, 0)"_s;
    case LineForm::CanonicalEnd:
        return edges + u": a and b counted from the end that is smaller in (x, y)"_s;
    case LineForm::FirstEnd:
        return edges + u": a and b counted from the first end of the edge"_s;
    }
    return edges + u": a, b, c from the two ends of the edge"_s;
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
        return u"% = E₀/F₀·%₂ + E₁/F₁·%₀ + E₂/F₂·%₁"_s;
    if (m_form.inside == InsideTest::Cramer)
        return u"% = u·%_A + v·%_B + w·%_C"_s;
    if (m_form.evaluation == Evaluation::Increments)
        return u"% ← %′ + Δ%_y"_s;
    return u"% = α·%_a + β·%_b + γ·%_c"_s;
}

QString EdgeTestNames::tieText(FillRule rule) const
{
    return rule == FillRule::OffScreenPoint ? u"{value}({letter})·{value}(r) > 0"_s
                                            : u"tie{l} = 1"_s;
}

QString EdgeTestNames::cramerText(FillRule rule) const
{
    if (rule == FillRule::Closed)
        return u"if u ≥ 0 and v ≥ 0 and u + v ≤ 1:"_s;
    if (rule == FillRule::Open)
        return u"if u > 0 and v > 0 and u + v < 1:"_s;
    constexpr std::array inside
        = {u"u > 0, or u = 0", u"v > 0, or v = 0", u"u + v < 1, or u + v = 1"};
    QStringList tests;
    for (std::size_t line = 0; line < 3; ++line)
        tests.append(QString::fromUtf16(inside[line]) + u" and "_s + filled(tieText(rule), line));
    return u"if "_s + tests.join(u"; "_s) + u':';
}

} // namespace pixelplumb
