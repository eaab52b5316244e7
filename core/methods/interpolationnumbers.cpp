// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationnumbers.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/placenumbers.h"
#include "core/methods/units.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// Where the column lies and what it covers.
void appendPlace(NumberTable<InterpolationSpanState> &table)
{
    using State = InterpolationSpanState;
    table.push_back({triangleNumber(), [](const State &state) {
                         return Quantity::integer(Int128(state.walk.primitive));
                     }});
    table.push_back(
        {scannedNumber(), [](const State &state) { return Quantity::integer(state.column.x); }});
    table.push_back({halfNumber(), [](const State &state) {
                         return Quantity::integer(state.column.half == ColumnHalf::First ? 1 : 2);
                     }});
    table.push_back(
        {{.id = QStringLiteral("first_row"),
          .title = QStringLiteral("y_first"),
          .unit = unit::px(),
          .toolTip = QStringLiteral("The first covered row; exact in every arithmetic."),
          .formula = {},
          .group = Group::Span},
         [](const State &state) { return Quantity::integer(state.column.firstRow); }});
    table.push_back(
        {{.id = QStringLiteral("last_row"),
          .title = QStringLiteral("y_last"),
          .unit = unit::px(),
          .toolTip = QStringLiteral("The last covered row; exact in every arithmetic."),
          .formula = {},
          .group = Group::Span},
         [](const State &state) { return Quantity::integer(state.column.endRow - 1); }});
    table.push_back({columnPixelsNumber(),
                     [](const State &state) { return Quantity::integer(state.drawnSamples()); }});
}

/// The walk along the edges is told as the column scan's.
const EdgeWalkNames &columnNames()
{
    static const EdgeWalkNames names(
        EdgeWalkForm{SpanAxis::Column, WalkForm::Accumulated, ColourRate::Bilinear});
    return names;
}

void appendBounds(NumberTable<InterpolationSpanState> &table)
{
    const auto row = [&table](SpanBound bound, const QString &title, const QString &edge,
                              Quantity InterpolationColumn<Quantity>::*value) {
        table.push_back(
            {comparedNumber(title, title, unit::px(),
                            QStringLiteral("Where the %1 edge meets the column, as the channels "
                                           "use it.")
                                .arg(edge),
                            QStringLiteral("%1 ← %1′ + m").arg(title), Group::Span),
             [value](const InterpolationSpanState &state) { return state.column.*value; },
             [=](NumberDescription &number, const InterpolationSpanState &state) {
                 number.formula = columnNames().boundFormula(
                     state.walk, bound, title, QStringLiteral("y"), QStringLiteral("m"));
             }});
    };
    row(SpanBound::Lower, QStringLiteral("y_B"), QStringLiteral("lower"),
        &InterpolationColumn<Quantity>::yBottom);
    row(SpanBound::Upper, QStringLiteral("y_T"), QStringLiteral("upper"),
        &InterpolationColumn<Quantity>::yTop);
}

/// The channels where an edge meets the column.
void appendBoundValues(NumberTable<InterpolationSpanState> &table, const CarriedChannels &carried,
                       SpanBound bound,
                       std::array<Quantity, channelCount> InterpolationColumn<Quantity>::*values)
{
    const bool isLower = bound == SpanBound::Lower;
    for (std::size_t place = 0; place < carried.count(); ++place) {
        const QString &name = channelName(carried.at(place));
        const QString title
            = withSubscript(name, isLower ? QStringLiteral("B") : QStringLiteral("T"));
        table.push_back(
            {comparedNumber(
                 title, title, channelUnit(place),
                 QStringLiteral("%1 where the %2 edge meets the column; its rate is "
                                "added from column to column.")
                     .arg(name, isLower ? QStringLiteral("lower") : QStringLiteral("upper")),
                 QStringLiteral("%1 ← %1′ + δ%2").arg(title, name), Group::EdgeColours),
             [=](const InterpolationSpanState &state) { return (state.column.*values)[place]; },
             [=](NumberDescription &number, const InterpolationSpanState &state) {
                 number.formula = columnNames().boundFormula(state.walk, bound, title, name,
                                                             QStringLiteral("δ") + name);
             }});
    }
}

void appendRates(NumberTable<InterpolationSpanState> &table, const CarriedChannels &carried)
{
    for (std::size_t place = 0; place < carried.count(); ++place) {
        const QString &name = channelName(carried.at(place));
        table.push_back(
            {comparedNumber(QStringLiteral("delta_") + name, u'Δ' + name, channelUnit(place),
                            QStringLiteral("Change of %1 for each upward move; none where y_B = "
                                           "y_T, with nothing to share out.")
                                .arg(name),
                            QStringLiteral("Δ%1 = (%2 − %3)/(y_T − y_B)")
                                .arg(name, withSubscript(name, QStringLiteral("T")),
                                     withSubscript(name, QStringLiteral("B"))),
                            Group::ColourRates),
             [=](const InterpolationSpanState &state) {
                 return state.hasRate() ? state.column.rate[place] : Quantity();
             }});
    }
}

void appendWeights(NumberTable<InterpolationSampleState> &table)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const QString title = weightTitle(i);
        table.push_back(
            {comparedNumber(weightId(i), title, {},
                            QStringLiteral("Weight of vertex %1: 1 there, 0 on the line through "
                                           "the other two.")
                                .arg(i),
                            QStringLiteral("%1 = a_%1·x + b_%1·y + c_%1").arg(title),
                            Group::Decision),
             [i](const InterpolationSampleState &state) { return state.weight[i]; }});
    }
}

QString valueFormula(InterpolationForm form, const QString &name)
{
    switch (form) {
    case InterpolationForm::Bilinear:
        return QStringLiteral("%1 ← %1′ + Δ%1").arg(name);
    case InterpolationForm::Plane:
        return QStringLiteral("%1 = %2·x + %3·y + %4")
            .arg(name, coefficientOf(QStringLiteral("a"), name),
                 coefficientOf(QStringLiteral("b"), name),
                 coefficientOf(QStringLiteral("c"), name));
    case InterpolationForm::Barycentric:
        // Not by arg(), which takes a subscript after a place-marker for one of its digits.
        return name + QStringLiteral(" = α·") + name + QStringLiteral("₀ + β·") + name
            + QStringLiteral("₁ + γ·") + name + u'₂';
    }
    return {};
}

/// Along the segment of a triangle without an area, from P0 to P2 in the digits of the form.
QString segmentFormula(InterpolationForm form, const QString &name,
                       const InterpolationSampleState &state)
{
    const bool isSorted = form == InterpolationForm::Bilinear;
    const QChar first = vertexDigits[isSorted ? 0 : std::size_t(state.order[0])];
    const QChar last = vertexDigits[isSorted ? 2 : std::size_t(state.order[2])];
    const QString value = state.isPoint ? QStringLiteral("% = %#")
                                        : QStringLiteral("% = %# + (@ − @#)·((%& − %#)/(@& − @#))");
    return QString(value)
        .replace(u'@', state.start.isVertical ? u'y' : u'x')
        .replace(u'#', first)
        .replace(u'&', last)
        .replace(u'%', name);
}

/// Without a change along the column its one sample has what its bound has.
void specifyValue(NumberDescription &number, InterpolationForm form, const QString &name,
                  const InterpolationSampleState &state)
{
    if (!state.start.hasPlane) {
        number.formula = segmentFormula(form, name, state);
        number.startFormula.clear();
    } else if (form == InterpolationForm::Bilinear && state.start.isPoint) {
        number.startFormula
            = name + QStringLiteral(" ← ") + withSubscript(name, QStringLiteral("B"));
    }
}

} // namespace

NumberTable<InterpolationSpanState> interpolationSpanNumbers(InterpolationForm form,
                                                             const CarriedChannels &carried)
{
    using Column = InterpolationColumn<Quantity>;
    NumberTable<InterpolationSpanState> table;
    appendPlace(table);
    if (form != InterpolationForm::Bilinear)
        return table;
    appendBounds(table);
    appendBoundValues(table, carried, SpanBound::Lower, &Column::bottom);
    appendBoundValues(table, carried, SpanBound::Upper, &Column::top);
    appendRates(table, carried);
    return table;
}

NumberTable<InterpolationSampleState> interpolationSampleNumbers(InterpolationForm form,
                                                                 const CarriedChannels &carried)
{
    NumberTable<InterpolationSampleState> table;
    if (form == InterpolationForm::Barycentric)
        appendWeights(table);
    for (std::size_t place = 0; place < carried.count(); ++place) {
        const QString &name = channelName(carried.at(place));
        NumberDescription number = comparedNumber(name, name, channelUnit(place),
                                                  QStringLiteral("%1 at the sample.").arg(name),
                                                  valueFormula(form, name), Group::FirstColour);
        if (form == InterpolationForm::Bilinear)
            number.startFormula = QStringLiteral("%1 ← %2 + (y − y_B)·Δ%1")
                                      .arg(name, withSubscript(name, QStringLiteral("B")));
        table.push_back(
            {number, [place](const InterpolationSampleState &state) { return state.value[place]; },
             [=](NumberDescription &description, const InterpolationSampleState &state) {
                 specifyValue(description, form, name, state);
             }});
    }
    return table;
}

} // namespace pixelplumb
