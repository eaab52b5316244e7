// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationnumbers.h"

#include "core/methods/interpolationnames.h"
#include "core/methods/placenumbers.h"
#include "core/methods/units.h"

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// Where the column or row lies and what it covers.
void appendPlace(NumberTable<InterpolationSpanState> &table, InterpolationForm form)
{
    const EdgeWalkNames names = walkNames(form);
    using State = InterpolationSpanState;
    table.push_back({triangleNumber(), [](const State &state) {
                         return Quantity::integer(Int128(state.walk.primitive));
                     }});
    table.push_back({names.filled({.id = QStringLiteral("{c}"),
                                   .title = QStringLiteral("{c}"),
                                   .unit = unit::px(),
                                   .toolTip = QStringLiteral("The {span}."),
                                   .formula = {}}),
                     [isRow = names.isRow()](const State &state) {
                         return Quantity::integer(isRow ? -state.column.x : state.column.x);
                     }});
    NumberDescription half = halfNumberOf(form);
    half.id = half.title = QStringLiteral("{half}");
    table.push_back(
        {names.filled(half), [](const State &state) { return state.walk.halfNumber(); }});
    const auto covered = [&](const QString &which, const auto &read) {
        table.push_back(
            {names.filled({.id = which + QStringLiteral("_{across}"),
                           .title = QStringLiteral("{a}_") + which,
                           .unit = unit::px(),
                           .toolTip = QStringLiteral("The %1 covered {across}; exact in every "
                                                     "arithmetic.")
                                          .arg(which),
                           .formula = {},
                           .group = Group::Span}),
             read});
    };
    covered(QStringLiteral("first"),
            [](const State &state) { return Quantity::integer(state.column.firstRow); });
    covered(QStringLiteral("last"),
            [](const State &state) { return Quantity::integer(state.column.endRow - 1); });
    NumberDescription pixels = columnPixelsNumber();
    pixels.toolTip.replace(QStringLiteral("column"), QStringLiteral("{span}"));
    table.push_back({names.filled(pixels),
                     [](const State &state) { return Quantity::integer(state.drawnSamples()); }});
}

void appendBounds(NumberTable<InterpolationSpanState> &table, const EdgeWalkNames &names)
{
    const auto row = [&](SpanBound bound, const QString &pattern, const QString &edge,
                         Quantity InterpolationColumn<Quantity>::*value) {
        const QString title = names.filled(pattern);
        table.push_back(
            {names.filled(comparedNumber(
                 title, title, unit::px(),
                 QStringLiteral("Where the %1 edge meets the {span}, as the channels use it.")
                     .arg(edge),
                 QStringLiteral("%1 ← %1′ + m").arg(title), Group::Span)),
             [value](const InterpolationSpanState &state) { return state.column.*value; },
             [=](NumberDescription &number, const InterpolationSpanState &state) {
                 number.formula
                     = names.boundFormula(state.walk, bound, title,
                                          names.filled(QStringLiteral("{a}")), QStringLiteral("m"));
             }});
    };
    row(SpanBound::Lower, QStringLiteral("{a}_{lo}"), QStringLiteral("{lower}"),
        &InterpolationColumn<Quantity>::yBottom);
    row(SpanBound::Upper, QStringLiteral("{a}_{hi}"), QStringLiteral("{upper}"),
        &InterpolationColumn<Quantity>::yTop);
}

/// The channels where an edge meets the column or row.
void appendBoundValues(NumberTable<InterpolationSpanState> &table, const EdgeWalkNames &names,
                       const CarriedChannels &carried, SpanBound bound,
                       std::array<Quantity, channelCount> InterpolationColumn<Quantity>::*values)
{
    const bool isLower = bound == SpanBound::Lower;
    for (std::size_t place = 0; place < carried.count(); ++place) {
        const QString &name = channelName(carried.at(place));
        const QString title = names.filled(
            withSubscript(name, isLower ? QStringLiteral("{lo}") : QStringLiteral("{hi}")));
        table.push_back(
            {names.filled(comparedNumber(
                 title, title, channelUnit(place),
                 QStringLiteral("%1 where the %2 edge meets the {span}; its rate is "
                                "added from {span} to {span}.")
                     .arg(name, isLower ? QStringLiteral("{lower}") : QStringLiteral("{upper}")),
                 QStringLiteral("%1 ← %1′ + δ%2").arg(title, name), Group::EdgeColours)),
             [=](const InterpolationSpanState &state) { return (state.column.*values)[place]; },
             [=](NumberDescription &number, const InterpolationSpanState &state) {
                 number.formula = names.boundFormula(state.walk, bound, title, name,
                                                     QStringLiteral("δ") + name);
             }});
    }
}

void appendRates(NumberTable<InterpolationSpanState> &table, const EdgeWalkNames &names,
                 const CarriedChannels &carried)
{
    for (std::size_t place = 0; place < carried.count(); ++place) {
        const QString &name = channelName(carried.at(place));
        table.push_back(
            {names.filled(comparedNumber(
                 QStringLiteral("delta_") + name, u'Δ' + name,
                 channelUnit(place, QStringLiteral("/{across}")),
                 QStringLiteral("Change of %1 from {across} to {across}, {a} growing; none "
                                "where {a}_{lo} = "
                                "{a}_{hi}, with "
                                "nothing to share out.")
                     .arg(name),
                 QStringLiteral("Δ%1 = (%2 − %3)/({a}_{hi} − {a}_{lo})")
                     .arg(name, withSubscript(name, QStringLiteral("{hi}")),
                          withSubscript(name, QStringLiteral("{lo}"))),
                 Group::ColourRates)),
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
                            QStringLiteral("Weight of P%1: 1 there, 0 on the line through the "
                                           "other two.")
                                .arg(vertexDigits[i]),
                            QStringLiteral("%1 = a_%1·x + b_%1·y + c_%1").arg(title),
                            Group::Decision),
             [i](const InterpolationSampleState &state) { return state.weight[i]; }});
    }
}

QString valueFormula(InterpolationForm form, const QString &name)
{
    switch (form) {
    case InterpolationForm::Bilinear:
    case InterpolationForm::BilinearRows:
        return QStringLiteral("%1 ← %1′ + Δ%1").arg(name);
    case InterpolationForm::Plane:
        return QStringLiteral("%1 = %2·x + %3·y + %4")
            .arg(name, coefficientOf(QStringLiteral("a"), name),
                 coefficientOf(QStringLiteral("b"), name),
                 coefficientOf(QStringLiteral("c"), name));
    case InterpolationForm::Barycentric:
        // Not arg(), which would read a subscript after a place marker as one of its digits.
        return name + QStringLiteral(" = α·") + name + QStringLiteral("₀ + β·") + name
            + QStringLiteral("₁ + γ·") + name + u'₂';
    }
    return {};
}

/// Along the segment of a triangle without an area, from P0 to P2 in the digits of the form.
QString segmentFormula(InterpolationForm form, const QString &name,
                       const InterpolationSampleState &state)
{
    const bool isSorted = isBilinear(form);
    const QChar first = vertexDigits[isSorted ? 0 : std::size_t(state.order[0])];
    const QChar last = vertexDigits[isSorted ? 2 : std::size_t(state.order[2])];
    const bool isRow = axisOf(form) == SpanAxis::Row;
    // Rows are walked downwards, along growing −y.
    const QString value = state.isPoint ? QStringLiteral("% = %#")
        : isRow && !state.start.isVertical
        ? QStringLiteral("% = %# + (@# − @)·((%& − %#)/(@# − @&))")
        : QStringLiteral("% = %# + (@ − @#)·((%& − %#)/(@& − @#))");
    return QString(value)
        .replace(u'@', state.start.isVertical != isRow ? u'y' : u'x')
        .replace(u'#', first)
        .replace(u'&', last)
        .replace(u'%', name);
}

/// Without a change along the column its samples have the bound's value.
void specifyValue(NumberDescription &number, InterpolationForm form, const QString &name,
                  const InterpolationSampleState &state)
{
    if (!state.start.hasPlane) {
        number.formula = segmentFormula(form, name, state);
        number.startFormula.clear();
    } else if (form == InterpolationForm::Barycentric && state.hasOneColour
               && QStringLiteral("RGB").contains(name)) {
        number.formula = name + QStringLiteral(" = ") + name + u'₀';
    } else if (isBilinear(form) && state.start.isPoint) {
        number.formula = QStringLiteral("%1 ← %1′").arg(name);
        number.startFormula = walkNames(form).filled(name + QStringLiteral(" ← ")
                                                     + withSubscript(name, QStringLiteral("{lo}")));
    }
}

} // namespace

NumberTable<InterpolationSpanState> interpolationSpanNumbers(InterpolationForm form,
                                                             const CarriedChannels &carried)
{
    using Column = InterpolationColumn<Quantity>;
    NumberTable<InterpolationSpanState> table;
    appendPlace(table, form);
    if (!isBilinear(form))
        return table;
    const EdgeWalkNames names = walkNames(form);
    appendBounds(table, names);
    appendBoundValues(table, names, carried, SpanBound::Lower, &Column::bottom);
    appendBoundValues(table, names, carried, SpanBound::Upper, &Column::top);
    appendRates(table, names, carried);
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
        if (isBilinear(form))
            number.startFormula = walkNames(form).filled(
                QStringLiteral("%1 ← %2 + ({a} − {a}_{lo})·Δ%1")
                    .arg(name, withSubscript(name, QStringLiteral("{lo}"))));
        table.push_back(
            {number, [place](const InterpolationSampleState &state) { return state.value[place]; },
             [=](NumberDescription &description, const InterpolationSampleState &state) {
                 specifyValue(description, form, name, state);
             }});
    }
    return table;
}

} // namespace pixelplumb
