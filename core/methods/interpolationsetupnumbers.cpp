// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/interpolationnumbers.h"
#include "core/methods/units.h"

#include <array>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The vertex that a digit names: in the bilinear forms vertices are sorted.
std::size_t vertexIn(const InterpolationSetUpState &state, InterpolationForm form,
                     std::size_t digit)
{
    return isBilinear(form) ? std::size_t(state.order[digit]) : digit;
}

void appendPositions(NumberTable<InterpolationSetUpState> &table, InterpolationForm form)
{
    const QString owner = isBilinear(form)
        ? QStringLiteral("%1 of the sorted vertex P%2, from the centre of pixel (0, 0).")
        : QStringLiteral("%1 of P%2, as it is given, from the centre of pixel (0, 0).");
    for (std::size_t digit = 0; digit < 3; ++digit) {
        for (const auto &[axis, coordinate] :
             {std::pair(u'x', &LatticePoint::x), std::pair(u'y', &LatticePoint::y)})
            table.push_back({{.id = QStringLiteral("%1_%2").arg(QChar(axis)).arg(digit),
                              .title = QString(QChar(axis)) + vertexDigits[digit],
                              .unit = unit::px(),
                              .toolTip = owner.arg(QChar(axis)).arg(vertexDigits[digit]),
                              .formula = {}},
                             [=, coordinate = coordinate](const InterpolationSetUpState &state) {
                                 return pixels(state.vertices[vertexIn(state, form, digit)].position
                                               .*coordinate);
                             }});
    }
}

/// A carried channel: its place among the carried ones, and its name.
struct PlacedChannel {
    std::size_t place;
    QString name;
};

void appendValues(NumberTable<InterpolationSetUpState> &table, InterpolationForm form,
                  const PlacedChannel &channel)
{
    const auto &[place, name] = channel;
    for (std::size_t digit = 0; digit < 3; ++digit) {
        table.push_back(
            {{.id = name + QString::number(digit),
              .title = name + vertexDigits[digit],
              .unit = channelUnit(place),
              .toolTip = QStringLiteral("%1 at P%2.").arg(name).arg(vertexDigits[digit]),
              .formula = {},
              .group = Group::EdgeColours},
             [form, digit, at = place](const InterpolationSetUpState &state) {
                 const std::size_t vertex = vertexIn(state, form, digit);
                 return Quantity::rational(state.vertices[vertex].channels[at], unitsOfChannel(at));
             }});
    }
}

/// A number that is 0 throughout, because no vertex carries the channel, needs no formula.
NumberRow<InterpolationSetUpState>::Specify ifCarried(std::size_t channel)
{
    return [channel](NumberDescription &number, const InterpolationSetUpState &state) {
        if (!state.carries(channel))
            number.formula.clear();
    };
}

/// N = ⟨A, B, C⟩ and D of the plane through the three values; % stands for the channel.
void appendNormal(NumberTable<InterpolationSetUpState> &table, const PlacedChannel &channel)
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
    const auto &[place, name] = channel;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const QString title = coefficientOf(QString::fromUtf16(components[i].name), name);
        QString formula = title + QStringLiteral(" = ") + QString::fromUtf16(components[i].formula);
        if (i == 3)
            for (const char16_t letter : {u'A', u'B', u'C'})
                formula.replace(QStringLiteral("{%1}").arg(QChar(letter)),
                                coefficientOf(QString(QChar(letter)), name));
        table.push_back(
            {comparedNumber(QStringLiteral("normal_") + title, title,
                            components[i].unit
                                ? channelUnit(place, QString::fromUtf16(components[i].unit))
                                : unit::squarePx(),
                            i < 3 ? QString::fromUtf16(components[i].name)
                                    + QStringLiteral(" of the normal N = (P₁ − P₀) × (P₂ − P₀) of "
                                                     "the plane through the three values of ")
                                    + name + u'.'
                                  : QStringLiteral("D = −N·P₀ of the plane of ") + name + u'.',
                            formula.replace(u'%', name), Group::ColourRates),
             [i, at = place](const InterpolationSetUpState &state) { return state.normal[at][i]; },
             ifCarried(place)});
    }
}

void appendPlane(NumberTable<InterpolationSetUpState> &table, const PlacedChannel &channel)
{
    constexpr std::array<char16_t, 3> coefficients = {u'a', u'b', u'c'};
    constexpr std::array<char16_t, 3> dividends = {u'A', u'B', u'D'};
    const auto &[place, name] = channel;
    for (std::size_t i = 0; i < 3; ++i) {
        const QString title = coefficientOf(QString(QChar(coefficients[i])), name);
        table.push_back(
            {comparedNumber(title, title,
                            channelUnit(place, i < 2 ? QStringLiteral("/px") : QString()),
                            QStringLiteral("%1 of %2 = a·x + b·y + c, the plane through the three "
                                           "values of %2.")
                                .arg(QChar(coefficients[i]))
                                .arg(name),
                            QStringLiteral("%1 = −%2/%3")
                                .arg(title, coefficientOf(QString(QChar(dividends[i])), name),
                                     coefficientOf(QStringLiteral("C"), name)),
                            Group::ColourRates),
             [i, at = place](const InterpolationSetUpState &state) { return state.plane[at][i]; },
             ifCarried(place)});
    }
}

/// The line that faces a vertex, the k that makes it 1 there, and both together.
void appendWeightLine(NumberTable<InterpolationSetUpState> &table, std::size_t vertex)
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
            {comparedNumber(QStringLiteral("line_%1_%2").arg(letter).arg(weightId(vertex)),
                            QStringLiteral("%1_%2").arg(letter).arg(weight), {},
                            letter + u' ' + filled(toolTip), filled(formula), Group::Decision),
             [=](const InterpolationSetUpState &state) { return state.line[vertex][part]; }});
    };
    const auto ofLine
        = QStringLiteral("of F(x, y) = A·x + B·y + C, the line through the vertices that "
                         "do not face it: that of the weight %.");
    line(0, u'A', ofLine, QStringLiteral("A_% = y& − y#"));
    line(1, u'B', ofLine, QStringLiteral("B_% = x# − x&"));
    line(2, u'C', ofLine, QStringLiteral("C_% = −A_%·x# − B_%·y#"));
    line(3, u'k', QStringLiteral("scales F to 1 at P@."),
         QStringLiteral("k_% = 1/(A_%·x@ + B_%·y@ + C_%)"));
    constexpr std::array<char16_t, 3> coefficients = {u'a', u'b', u'c'};
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QChar(coefficients[i]);
        table.push_back(
            {comparedNumber(
                 letter + u'_' + weightId(vertex), letter + u'_' + weight, {},
                 letter
                     + filled(QStringLiteral(" of the line through the other two vertices, scaled "
                                             "to 1 at P@.")),
                 filled(letter + QStringLiteral("_% = k_%·") + letter.toUpper()
                        + QStringLiteral("_%")),
                 Group::Decision),
             [=](const InterpolationSetUpState &state) { return state.weight[vertex][i]; }});
    }
}

/// What each column adds to y along an edge, each row to x.
void appendSlope(NumberTable<InterpolationSetUpState> &table, const EdgeWalkNames &names,
                 SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString title = u'm' + subscriptOf(edge);
    table.push_back(
        {names.filled(comparedNumber(
             QStringLiteral("m_%1%2").arg(ends[0]).arg(ends[1]), title, QStringLiteral("px/{span}"),
             QStringLiteral("Slope of %1: what each {span} adds to "
                            "its {a}; none where it lies "
                            "along the {span}s.")
                 .arg(nameOf(edge)),
             QStringLiteral("%1 = ({a}%3 − {a}%2)/%4")
                 .arg(title, QString(vertexDigits[ends[0]]), QString(vertexDigits[ends[1]]),
                      names.way(ends[0], ends[1])),
             Group::Position)),
         [edge](const InterpolationSetUpState &state) { return state.slope[std::size_t(edge)]; }});
}

void appendRate(NumberTable<InterpolationSetUpState> &table, const EdgeWalkNames &names,
                SortedEdge edge, const PlacedChannel &channel)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const auto &[place, name] = channel;
    const QString title = u'δ' + name + subscriptOf(edge);
    table.push_back(
        {names.filled(comparedNumber(
             QStringLiteral("rate_%1_%2%3").arg(name).arg(ends[0]).arg(ends[1]), title,
             channelUnit(place, QStringLiteral("/{span}")),
             QStringLiteral("What each {span} adds to %1 along %2.").arg(name, nameOf(edge)),
             title + QStringLiteral(" = (") + name + vertexDigits[ends[1]] + QStringLiteral(" − ")
                 + name + vertexDigits[ends[0]] + QStringLiteral(")/")
                 + names.way(ends[0], ends[1]),
             Group::ColourRates)),
         [edge, at = place](const InterpolationSetUpState &state) {
             return state.rate[std::size_t(edge)][at];
         },
         ifCarried(place)});
}

} // namespace

NumberTable<InterpolationSetUpState> interpolationSetUpNumbers(InterpolationForm form,
                                                               const CarriedChannels &carried)
{
    std::vector<PlacedChannel> channels;
    for (std::size_t place = 0; place < carried.count(); ++place)
        channels.push_back({place, channelName(carried.at(place))});
    NumberTable<InterpolationSetUpState> table;
    appendPositions(table, form);
    for (const PlacedChannel &channel : channels)
        appendValues(table, form, channel);
    switch (form) {
    case InterpolationForm::Bilinear:
    case InterpolationForm::BilinearRows:
        for (const SortedEdge edge : sortedEdges)
            appendSlope(table, walkNames(form), edge);
        for (const PlacedChannel &channel : channels) {
            for (const SortedEdge edge : sortedEdges)
                appendRate(table, walkNames(form), edge, channel);
        }
        break;
    case InterpolationForm::Plane:
        for (const PlacedChannel &channel : channels) {
            appendNormal(table, channel);
            appendPlane(table, channel);
        }
        break;
    case InterpolationForm::Barycentric:
        for (std::size_t vertex = 0; vertex < 3; ++vertex)
            appendWeightLine(table, vertex);
        break;
    }
    return table;
}

} // namespace pixelplumb
