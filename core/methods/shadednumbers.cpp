// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shadednumbers.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/units.h"

#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// The vertex that a digit names: of the bilinear form they are sorted by x.
std::size_t vertexIn(const ShadedSetUpState &state, InterpolationForm form, std::size_t digit)
{
    return form == InterpolationForm::Bilinear ? std::size_t(state.order[digit]) : digit;
}

void appendVertices(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope)
{
    const InterpolationForm form = scope.form;
    const QString owner = form == InterpolationForm::Bilinear
        ? QStringLiteral("%1 of the sorted vertex P%2")
        : QStringLiteral("%1 of P%2, as it is given");
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const auto row = [&](const QString &name, const QString &unit, const QString &toolTip,
                             const auto &read) {
            table.push_back({{.id = name + QString::number(digit),
                              .title = name + vertexDigits[digit],
                              .unit = unit,
                              .toolTip = owner.arg(name).arg(vertexDigits[digit]) + toolTip,
                              .formula = {}},
                             [=](const ShadedSetUpState &state) {
                                 return read(state, vertexIn(state, form, digit));
                             }});
        };
        const QString fromCentre = QStringLiteral(", from the centre of pixel (0, 0).");
        row(QStringLiteral("x"), unit::px(), fromCentre,
            [](const ShadedSetUpState &state, std::size_t vertex) {
                return pixels(state.position[vertex].x);
            });
        row(QStringLiteral("y"), unit::px(), fromCentre,
            [](const ShadedSetUpState &state, std::size_t vertex) {
                return pixels(state.position[vertex].y);
            });
        if (scope.effects.perspective)
            row(QStringLiteral("w"), {}, QStringLiteral(": what the camera divided by."),
                [](const ShadedSetUpState &state, std::size_t vertex) { return state.w[vertex]; });
    }
}

/// A channel at the vertices; where perspective is corrected, also divided by w.
void appendValues(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope,
                  std::size_t channel)
{
    const InterpolationForm form = scope.form;
    const Channel which = channelAt(channel);
    const bool isDivided = scope.effects.perspective && which != Channel::Depth;
    for (std::size_t digit = 0; digit < 3; ++digit) {
        const QString given = shadedName(which);
        if (which != Channel::Reciprocal)
            table.push_back(
                {{.id = given + QString::number(digit),
                  .title = given + vertexDigits[digit],
                  .unit = unitOf(which),
                  .toolTip = QStringLiteral("%1 at P%2.").arg(given).arg(vertexDigits[digit]),
                  .formula = {},
                  .group = Group::EdgeColours},
                 [=](const ShadedSetUpState &state) {
                     return state.given[channel][vertexIn(state, form, digit)];
                 }});
        if (!isDivided)
            continue;
        const QString name = linearName(which, scope.effects);
        const QString above
            = which == Channel::Reciprocal ? QStringLiteral("1") : given + vertexDigits[digit];
        table.push_back(
            {comparedNumber(
                 name + QString::number(digit), name + vertexDigits[digit], unitOf(which),
                 QStringLiteral("%1 at P%2 divided by its w: what is linear in the frame.")
                     .arg(which == Channel::Reciprocal ? QStringLiteral("1") : given)
                     .arg(vertexDigits[digit]),
                 QStringLiteral("%1 = %2/w%3")
                     .arg(name + vertexDigits[digit], above, vertexDigits[digit]),
                 Group::EdgeColours),
             [=](const ShadedSetUpState &state) {
                 return state.linear[channel][vertexIn(state, form, digit)];
             },
             [=](NumberDescription &number, const ShadedSetUpState &state) {
                 if (state.effects.perspective)
                     return;
                 number.formula = QStringLiteral("%1 = %2").arg(number.title, above);
                 number.toolTip
                     = QStringLiteral("%1 itself: no w differs in this triangle.").arg(above);
             }});
    }
}

constexpr std::array coefficientLetters = {u'a', u'b', u'c'};

/// The digits of the ends of the segment that a triangle without area is drawn as.
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
    /// With # and & for the ends, @ for the coordinate.
    QString filled(QString text) const
    {
        return text.replace(u'#', first).replace(u'&', last).replace(u'@', along);
    }

    QChar first, last;
    QChar along; ///< x or y; null where the segment is a point
};

/// a, b or c of the plane through what the vertices have in %, or of the segment's line.
QString planeFormula(const ShadedSetUpState &state, QChar letter, const QString &name)
{
    const auto coefficient = [&](QChar other) { return coefficientOf(other, name); };
    QString text;
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        if (letter == u'c')
            text = ends.along.isNull() ? ends.filled(QStringLiteral("%#"))
                                       : ends.filled(QStringLiteral("%# − ")
                                                     + coefficient(ends.along == u'x' ? u'a' : u'b')
                                                     + QStringLiteral("·@#"));
        else
            text = ends.isAlong(letter) ? ends.filled(QStringLiteral("(%& − %#)/(@& − @#)"))
                                        : QStringLiteral("0");
    } else if (letter == u'a') {
        text = alongRowsText();
    } else if (letter == u'b') {
        text = alongColumnsText();
    } else {
        text = QStringLiteral("%₀ − %1·x₀ − %2·y₀").arg(coefficient(u'a'), coefficient(u'b'));
    }
    return coefficient(letter) + QStringLiteral(" = ") + text.replace(u'%', name);
}

/// a, b or c of the weight of a vertex: 1 there, 0 on the line through the other two.
QString weightFormula(const ShadedSetUpState &state, QChar letter, std::size_t vertex)
{
    const QString weight = weightTitle(vertex);
    const auto coefficient = [&](QChar other) { return coefficientOf(other, weight); };
    const QString left = coefficient(letter) + QStringLiteral(" = ");
    if (state.zeroArea) {
        const SegmentDigits ends(state);
        const bool isFirst = std::size_t(state.order[0]) == vertex;
        const bool isLast = std::size_t(state.order[2]) == vertex;
        if (letter != u'c')
            return left
                + (!ends.isAlong(letter) || !(isFirst || isLast)
                       ? QStringLiteral("0")
                       : ends.filled(isLast ? QStringLiteral("1/(@& − @#)")
                                            : QStringLiteral("−1/(@& − @#)")));
        if (ends.along.isNull() || !(isFirst || isLast))
            return left + (isFirst ? QStringLiteral("1") : QStringLiteral("0"));
        return left
            + ends.filled((isFirst ? QStringLiteral("1 − ") : QStringLiteral("−"))
                          + coefficient(ends.along == u'x' ? u'a' : u'b') + QStringLiteral("·@#"));
    }
    const auto filled = [&](QString text) {
        return text.replace(u'#', vertexDigits[(vertex + 1) % 3])
            .replace(u'&', vertexDigits[(vertex + 2) % 3])
            .replace(u'@', vertexDigits[vertex]);
    };
    const QString there = QStringLiteral("((y& − y#)·(x@ − x#) + (x# − x&)·(y@ − y#))");
    if (letter == u'c')
        return left
            + filled(QStringLiteral("−") + coefficient(u'a') + QStringLiteral("·x# − ")
                     + coefficient(u'b') + QStringLiteral("·y#"));
    return left
        + filled((letter == u'a' ? QStringLiteral("(y& − y#)/") : QStringLiteral("(x# − x&)/"))
                 + there);
}

/// a, b and c of a value or of a weight.
struct Coefficients {
    QString name; ///< of what they belong to
    QString unit; ///< its unit
    QString toolTip;
    std::function<Quantity(const ShadedSetUpState &, std::size_t)> read;
    std::function<QString(const ShadedSetUpState &, QChar)> formula;
};

void appendCoefficients(NumberTable<ShadedSetUpState> &table, const Coefficients &of)
{
    for (std::size_t k = 0; k < coefficientLetters.size(); ++k) {
        const QChar letter = coefficientLetters[k];
        const QString title = coefficientOf(letter, of.name);
        table.push_back(
            {comparedNumber(title, title,
                            k < 2 && !of.unit.isEmpty() ? of.unit + QStringLiteral("/px") : of.unit,
                            of.toolTip, {}, Group::ColourRates),
             [read = of.read, k](const ShadedSetUpState &state) { return read(state, k); },
             [formula = of.formula, letter](NumberDescription &number,
                                            const ShadedSetUpState &state) {
                 number.formula = formula(state, letter);
             }});
    }
}

/// The edge of the state between the vertices that the digits of an edge name.
std::size_t edgeIn(const ShadedSetUpState &state, InterpolationForm form, SortedEdge named)
{
    if (form == InterpolationForm::Bilinear)
        return std::size_t(named);
    const std::array digits
        = {std::size_t(state.order[0]), std::size_t(state.order[1]), std::size_t(state.order[2])};
    for (const SortedEdge edge : sortedEdges) {
        if (subscriptOf(edge, digits) == subscriptOf(named))
            return std::size_t(edge);
    }
    return std::size_t(named);
}

/// "(% − %)/(x₁ − x₀)" of an edge; # and & are its ends, % the letter.
QString slopeFormula(const QString &title, SortedEdge edge, const QString &letter)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return title
        + QString(QStringLiteral(" = (%& − %#)/(x& − x#)"))
              .replace(u'#', vertexDigits[ends[0]])
              .replace(u'&', vertexDigits[ends[1]])
              .replace(u'%', letter);
}

/// What each column adds to y along an edge.
void appendSlope(NumberTable<ShadedSetUpState> &table, InterpolationForm form, SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString title = u'm' + subscriptOf(edge);
    table.push_back(
        {comparedNumber(
             QStringLiteral("m_%1%2").arg(ends[0]).arg(ends[1]), title, QStringLiteral("px/column"),
             QStringLiteral("Slope of the edge from P%1 to P%2: what each column adds to its y; "
                            "none where it is vertical.")
                 .arg(vertexDigits[ends[0]])
                 .arg(vertexDigits[ends[1]]),
             slopeFormula(title, edge, QStringLiteral("y")), Group::Position),
         [=](const ShadedSetUpState &state) { return state.slope[edgeIn(state, form, edge)]; }});
}

/// What each column adds to a channel along an edge.
void appendRate(NumberTable<ShadedSetUpState> &table, const ShadedScope &scope, std::size_t channel,
                SortedEdge edge)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const QString name = linearName(channelAt(channel), scope.effects);
    const QString title = u'δ' + name + subscriptOf(edge);
    table.push_back(
        {comparedNumber(
             QStringLiteral("rate_%1_%2%3").arg(name).arg(ends[0]).arg(ends[1]), title,
             isLevel(channelAt(channel)) ? QStringLiteral("levels/column") : QString(),
             QStringLiteral("What each column adds to %1 along %2.").arg(name, nameOf(edge)),
             slopeFormula(title, edge, name), Group::ColourRates),
         [=](const ShadedSetUpState &state) { return state.rate[std::size_t(edge)][channel]; }});
}

} // namespace

NumberTable<ShadedSetUpState> shadedSetUpNumbers(const ShadedScope &scope)
{
    NumberTable<ShadedSetUpState> table;
    appendVertices(table, scope);
    forEachChannel(scope.effects,
                   [&](std::size_t channel) { appendValues(table, scope, channel); });
    for (const SortedEdge edge : sortedEdges)
        appendSlope(table, scope.form, edge);
    if (scope.form == InterpolationForm::Bilinear)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            for (const SortedEdge edge : sortedEdges)
                appendRate(table, scope, channel, edge);
        });
    if (scope.form == InterpolationForm::Plane)
        forEachChannel(scope.effects, [&](std::size_t channel) {
            const QString name = linearName(channelAt(channel), scope.effects);
            appendCoefficients(
                table,
                {name, unitOf(channelAt(channel)),
                 QStringLiteral("Of %1 = a·x + b·y + c over the triangle.").arg(name),
                 [channel](const ShadedSetUpState &state, std::size_t k) {
                     return state.plane[channel][k];
                 },
                 [name](const ShadedSetUpState &state, QChar letter) {
                     return planeFormula(state, letter, name);
                 }});
        });
    if (scope.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            appendCoefficients(
                table,
                {weightTitle(i),
                 {},
                 QStringLiteral("Of the weight of P%1, a·x + b·y + c.").arg(vertexDigits[i]),
                 [i](const ShadedSetUpState &state, std::size_t k) { return state.weight[i][k]; },
                 [i](const ShadedSetUpState &state, QChar letter) {
                     return weightFormula(state, letter, i);
                 }});
    }
    if (scope.appearance)
        appendLightSources(table, scope.appearance);
    return table;
}

} // namespace pixelplumb
