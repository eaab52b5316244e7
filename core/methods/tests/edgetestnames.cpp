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

QString EdgeTestNames::valueAt(std::size_t line, const QString &x, const QString &y) const
{
    if (m_form.inside != InsideTest::Cramer)
        return lineAt(x, y);
    const bool hasC = line != 2;
    return u"(y{to} − y{from})·(%1 − x%3) + (x{from} − x{to})·(%2 − y%3)"_s.arg(
        x, y, hasC ? u"_C"_s : u"{from}"_s);
}

QString EdgeTestNames::coefficients(const QString &each) const
{
    QStringList text;
    for (const QChar letter : u"abc"_s) {
        if (letter != u'c' || m_form.line == LineForm::Absolute || m_form.line == LineForm::Solved)
            text.append(QString(each).replace(u'%', letter));
    }
    return text.join(u", "_s);
}

QString EdgeTestNames::coefficientsText() const
{
    const QString pair = "y{to} − y{from}, x{from} − x{to}";
    if (m_form.line == LineForm::Solved)
        return u"(y{to} − y{from})/q{l}, (x{from} − x{to})/q{l}, −1 if q{l} ≠ 0, else %1, 0"_s.arg(
            pair);
    return m_form.line == LineForm::Absolute ? pair + u", x{to}·y{from} − x{from}·y{to}"_s : pair;
}

QString EdgeTestNames::tieCondition(FillRule rule, FrameOrigin origin) const
{
    if (rule == FillRule::OffScreenPoint)
        return towardsFacing("{value}(r)") + u" > 0"_s;
    const bool isCramer = m_form.inside == InsideTest::Cramer;
    const QString a = isCramer ? u"(y{to} − y{from})"_s : u"a{l}"_s;
    const QString b = isCramer ? u"(x{from} − x{to})"_s : u"b{l}"_s;
    const bool isTopLeft = rule == FillRule::TopLeft;
    const QString first = isTopLeft ? a : b, second = isTopLeft ? b : a;
    // Of level edges the top-left rule takes that at the top, from which the triangle goes down.
    const bool isNegative = isTopLeft && origin == FrameOrigin::BottomLeft;
    return u"%1 > 0, or %2 = 0 and %3 %4 0"_s.arg(
        towardsFacing(first), first, towardsFacing(second), QChar(isNegative ? u'<' : u'>'));
}

QString EdgeTestNames::tieRemark(FillRule rule)
{
    switch (rule) {
    case FillRule::TopLeft:
        return u" — a left edge, or a level one at the top"_s;
    case FillRule::HalfOpenColumn:
        return u" — an edge with the triangle at larger y, or an upright one with it at larger x"_s;
    case FillRule::OffScreenPoint:
        return u" — an edge with the triangle and r on the same side"_s;
    case FillRule::Closed:
    case FillRule::Open:
        break;
    }
    return {};
}

QString EdgeTestNames::towardsFacing(const QString &value) const
{
    if (m_form.inside == InsideTest::Cramer)
        return u"−D·"_s + value;
    return m_form.isBarycentric() ? u"f{opp}·"_s + value : value;
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
        tests.append(QString::fromUtf16(inside[line]) + filled(u" and tie{l} = 1"_s, line));
    return u"if "_s + tests.join(u"; "_s) + u':';
}

} // namespace pixelplumb
