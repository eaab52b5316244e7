// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"

#include <array>
#include <functional>

namespace pixelplumb {

namespace {

constexpr std::array coefficientLetters = {u'a', u'b', u'c'};

/// The digits of the ends of the segment that represents a triangle without area.
struct SegmentDigits {
    explicit SegmentDigits(const ShadedSetUpState &state)
        : first(vertexDigits[std::size_t(state.order[0])])
        , last(vertexDigits[std::size_t(state.order[2])])
    {
        const LatticePoint &from = state.position[std::size_t(state.order[0])];
        const LatticePoint &to = state.position[std::size_t(state.order[2])];
        if (from != to)
            along = from.x == to.x ? u'y' : u'x';
    }
    /// Whether a coefficient multiplies the coordinate that it is measured along.
    bool isAlong(QChar coefficient) const
    {
        return !along.isNull() && (coefficient == u'a') == (along == u'x');
    }
    /// Fills in # and & for the ends, @ for the coordinate.
    QString filled(QString text) const
    {
        return text.replace(u'#', first).replace(u'&', last).replace(u'@', along);
    }

    QChar first, last;
    QChar along; ///< x or y; null where the segment is a point
};

/// a, b or c of the plane through the vertices' values %, or of the segment's line.
QString planeFormula(const ShadedSetUpState &state, QChar letter, const QString &name)
{
    const auto coefficient = [&](QChar other) { return coefficientOf(other, name); };
    QString text;
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        if (letter == u'c')
            text = ends.along.isNull()
                ? ends.filled("%#")
                : ends.filled(u"%# − "_s + coefficient(ends.along == u'x' ? u'a' : u'b')
                              + u"·@#"_s);
        else
            text = ends.isAlong(letter) ? ends.filled("(%& − %#)/(@& − @#)") : u"0"_s;
    } else if (letter != u'c') {
        text = planeSlope(letter == u'a' ? u'x' : u'y');
    } else {
        text = u"%₀ − %1·x₀ − %2·y₀"_s.arg(coefficient(u'a'), coefficient(u'b'));
    }
    return coefficient(letter) + u" = "_s + text.replace(u'%', name);
}

/// a, b or c of the weight of a vertex: 1 there, 0 on the line through the other two.
QString weightFormula(const ShadedSetUpState &state, QChar letter, std::size_t vertex)
{
    const QString weight = weightTitle(vertex);
    const auto coefficient = [&](QChar other) { return coefficientOf(other, weight); };
    const QString left = coefficient(letter) + u" = "_s;
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        const bool isFirst = std::size_t(state.order[0]) == vertex;
        const bool isLast = std::size_t(state.order[2]) == vertex;
        if (letter != u'c')
            return left
                + (!ends.isAlong(letter) || !(isFirst || isLast)
                       ? u"0"_s
                       : ends.filled(isLast ? u"1/(@& − @#)"_s : u"−1/(@& − @#)"_s));
        if (ends.along.isNull() || !(isFirst || isLast))
            return left + (isFirst ? u"1"_s : u"0"_s);
        return left
            + ends.filled((isFirst ? u"1 − "_s : u"−"_s)
                          + coefficient(ends.along == u'x' ? u'a' : u'b') + u"·@#"_s);
    }
    const auto filled = [&](QString text) {
        return text.replace(u'#', vertexDigits[(vertex + 1) % 3])
            .replace(u'&', vertexDigits[(vertex + 2) % 3])
            .replace(u'@', vertexDigits[vertex]);
    };
    const QString there = "((y& − y#)·(x@ − x#) + (x# − x&)·(y@ − y#))";
    if (letter == u'c')
        return left
            + filled(u"−"_s + coefficient(u'a') + u"·x# − "_s + coefficient(u'b') + u"·y#"_s);
    return left + filled((letter == u'a' ? u"(y& − y#)/"_s : u"(x# − x&)/"_s) + there);
}

/// N = ⟨A, B, C⟩ and D of the plane through the three values; % stands for the channel.
void appendNormal(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                  const ScopedChannel &channel)
{
    struct Component {
        const char16_t *name;
        const char16_t *formula;
        const char16_t *unit; ///< times a level's; null for C, which is an area
    };
    constexpr std::array components
        = {Component{u"A", u"(y₁ − y₀)·(%₂ − %₀) − (%₁ − %₀)·(y₂ − y₀)", u"·px"},
           Component{u"B", u"(%₁ − %₀)·(x₂ − x₀) − (x₁ − x₀)·(%₂ − %₀)", u"·px"},
           Component{u"C", u"(x₁ − x₀)·(y₂ − y₀) − (y₁ − y₀)·(x₂ − x₀)", nullptr},
           Component{u"D", u"−({A}·x₀ + {B}·y₀ + {C}·%₀)", u"·px²"}};
    const QString name = shadedName(channel.which);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const QString title = coefficientOf(QString::fromUtf16(components[i].name), name);
        QString formula = title + u" = "_s + QString::fromUtf16(components[i].formula);
        if (i == 3)
            for (const char16_t letter : {u'A', u'B', u'C'})
                formula.replace(u"{%1}"_s.arg(QChar(letter)),
                                coefficientOf(QString(QChar(letter)), name));
        table.push_back(
            {comparedNumber(u"normal_"_s + title, title,
                            components[i].unit
                                ? unitOf(channel.which, QString::fromUtf16(components[i].unit))
                                : "px²",
                            i < 3 ? QString::fromUtf16(components[i].name)
                                    + u" of the normal N = (P₁ − P₀) × (P₂ − P₀) of "
                                      "the plane through the three values of "_s
                                    + name + u'.'
                                  : u"D = −N·P₀ of the plane of "_s + name + u'.',
                            formula.replace(u'%', name), NumberGroup::ColourRates),
             [i, at = channel.at](const ShadedSetUpState &state) { return state.normal[at][i]; },
             ifCarried(scope, channel.at)});
    }
}

/// The line that faces a vertex, and the k that makes it 1 there.
void appendWeightLine(NumberTable<ShadedSetUpState> &table, std::size_t vertex)
{
    const QString weight = weightTitle(vertex);
    // # and & are the line's ends, @ is the vertex, % the weight.
    const auto filled = [&](QString text) {
        return text.replace(u'#', vertexDigits[(vertex + 1) % 3])
            .replace(u'&', vertexDigits[(vertex + 2) % 3])
            .replace(u'@', vertexDigits[vertex])
            .replace(u'%', weight);
    };
    const auto line = [&](std::size_t part, QChar letter, const QString &toolTip,
                          const QString &formula) {
        table.push_back(
            {comparedNumber(u"line_%1_%2"_s.arg(letter).arg(weightId(vertex)),
                            u"%1_%2"_s.arg(letter).arg(weight), {}, letter + u' ' + filled(toolTip),
                            filled(formula), NumberGroup::Decision),
             [=](const ShadedSetUpState &state) { return state.line[vertex][part]; }});
    };
    const auto ofLine = u"of F(x, y) = A·x + B·y + C, the line through the vertices "
                        "that do not face it: that of the weight %."_s;
    line(0, u'A', ofLine, "A_% = y& − y#");
    line(1, u'B', ofLine, "B_% = x# − x&");
    line(2, u'C', ofLine, "C_% = −A_%·x# − B_%·y#");
    line(3, u'k', "scales F to 1 at P@.", "k_% = 1/(A_%·x@ + B_%·y@ + C_%)");
}

/// a, b and c of a value or of a weight.
struct Coefficients {
    QString name; ///< of the value or weight
    QString idName; ///< in files
    QString unit; ///< its unit
    QString toolTip; ///< after the letter
    NumberGroup group = NumberGroup::ColourRates;
    std::function<Quantity(const ShadedSetUpState &, std::size_t)> read;
    /// Where it is the same in every state.
    std::function<QString(QChar)> formula;
    std::function<void(NumberDescription &, const ShadedSetUpState &, QChar)> specify;
};

void appendCoefficients(NumberTable<ShadedSetUpState> &table, const Coefficients &of)
{
    for (std::size_t k = 0; k < coefficientLetters.size(); ++k) {
        const QChar letter = coefficientLetters[k];
        table.push_back(
            {comparedNumber(coefficientOf(letter, of.idName), coefficientOf(letter, of.name),
                            k < 2 && !of.unit.isEmpty() ? of.unit + u"/px"_s : of.unit,
                            letter + of.toolTip, of.formula ? of.formula(letter) : QString(),
                            of.group),
             [read = of.read, k](const ShadedSetUpState &state) { return read(state, k); },
             [specify = of.specify, letter](NumberDescription &number,
                                            const ShadedSetUpState &state) {
                 if (specify)
                     specify(number, state, letter);
             }});
    }
}

void appendPlane(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                 const ScopedChannel &channel)
{
    const QString name = linearName(channel.which, scope.effects);
    Coefficients plane{
        name,
        name,
        unitOf(channel.which),
        u" of %1 = a·x + b·y + c, the plane through its three values."_s.arg(name),
        NumberGroup::ColourRates,
        [at = channel.at](const ShadedSetUpState &state, std::size_t k) {
            return state.plane[at][k];
        },
        {},
        [name](NumberDescription &number, const ShadedSetUpState &state, QChar letter) {
            number.formula = planeFormula(state, letter, name);
        }};
    if (!scope.isPlanned) {
        plane.formula = [name](QChar letter) {
            const QChar dividend = letter == u'c' ? QChar(u'D') : letter.toUpper();
            return u"%1 = −%2/%3"_s.arg(coefficientOf(letter, name), coefficientOf(dividend, name),
                                        coefficientOf("C", name));
        };
        plane.specify = [clear = ifCarried(scope, channel.at)](NumberDescription &number,
                                                               const ShadedSetUpState &state,
                                                               QChar) { clear(number, state); };
    }
    appendCoefficients(table, plane);
}

void appendWeight(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                  std::size_t vertex)
{
    const QString name = weightTitle(vertex);
    Coefficients weight{
        name,
        name,
        {},
        u" of the weight of P%1, a·x + b·y + c."_s.arg(vertexDigits[vertex]),
        NumberGroup::ColourRates,
        [vertex](const ShadedSetUpState &state, std::size_t k) { return state.weight[vertex][k]; },
        {},
        [vertex](NumberDescription &number, const ShadedSetUpState &state, QChar letter) {
            number.formula = weightFormula(state, letter, vertex);
        }};
    if (!scope.isPlanned) {
        weight.idName = weightId(vertex);
        weight.group = NumberGroup::Decision;
        weight.formula = [name](QChar letter) {
            return u"%1_%2 = k_%2·%3_%2"_s.arg(letter).arg(name).arg(letter.toUpper());
        };
        weight.specify = {};
    }
    appendCoefficients(table, weight);
}

} // namespace

void appendPlanes(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    for (const ScopedChannel &channel : scope.channels) {
        if (scope.form != InterpolationForm::Plane)
            break;
        if (!scope.isPlanned)
            appendNormal(table, scope, channel);
        appendPlane(table, scope, channel);
    }
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        if (scope.form != InterpolationForm::Barycentric)
            break;
        if (!scope.isPlanned)
            appendWeightLine(table, vertex);
        appendWeight(table, scope, vertex);
    }
}

} // namespace pixelplumb
