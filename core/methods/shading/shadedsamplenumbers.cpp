// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"

#include <cmath>
#include <optional>
#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;
using State = ShadedSampleState;
using Table = NumberTable<State>;

/// A level is interpolated only if the vertices' levels differ.
QString atSampleText(Channel channel)
{
    const QString text = u"%1 at the sample"_s.arg(shadedName(channel));
    return isLevel(channel) ? text + u", interpolated; of a triangle of one colour, that colour"_s
                            : text;
}

/// Along the segment of a triangle without area, from P0 to P2 in the digits of the form.
QString segmentFormula(InterpolationForm form, const QString &name, const State &state)
{
    const bool isSorted = isBilinear(form);
    const QChar first = vertexDigits[isSorted ? 0 : std::size_t(state.order[0])];
    const QChar last = vertexDigits[isSorted ? 2 : std::size_t(state.order[2])];
    const bool isRow = axisOf(form) == SpanAxis::Row;
    // Rows are walked downwards, along growing −y.
    const QString value = state.start.isOnePoint ? u"% = %#"_s
        : isRow && !state.start.isVertical ? u"% = %# + (@# − @)·((%& − %#)/(@# − @&))"_s
                                           : u"% = %# + (@ − @#)·((%& − %#)/(@& − @#))"_s;
    return QString(value)
        .replace(u'@', state.start.isVertical != isRow ? u'y' : u'x')
        .replace(u'#', first)
        .replace(u'&', last)
        .replace(u'%', name);
}

/// In an interpolation by itself: without a change along the span its samples have the bound's
/// value.
void specifyValue(NumberDescription &number, InterpolationForm form, const QString &name,
                  const State &state)
{
    if (!state.start.hasPlane) {
        number.formula = segmentFormula(form, name, state);
        number.startFormula.clear();
    } else if (isBilinear(form) && state.start.isPoint) {
        number.formula = u"%1 ← %1′"_s.arg(name);
        number.startFormula = walkNames(form).filled(name + u" ← "_s + withSubscript(name, "{lo}"));
    }
}

/// A sample's value in a channel, linear in the frame.
void appendLinear(Table &table, const ShadedScope &scope, const ScopedChannel &channel)
{
    const auto [at, which] = channel;
    const InterpolationForm form = scope.form;
    const QString name = linearName(which, scope.effects);
    const QString direct = walkNames(form).filled(
        u"%1 ← %2 + ({a} − {a}_{lo})·Δ%1"_s.arg(name, withSubscript(name, "{lo}")));
    QString formula;
    switch (form) {
    case InterpolationForm::Bilinear:
    case InterpolationForm::BilinearRows:
        formula = u"%1 ← %1′ + Δ%1"_s.arg(name);
        break;
    case InterpolationForm::Plane:
        formula = u"%1 = %2·x + %3·y + %4"_s.arg(
            name, coefficientOf("a", name), coefficientOf("b", name), coefficientOf("c", name));
        break;
    case InterpolationForm::Barycentric:
        // Not arg(), which would read a subscript after a place marker as one of its digits.
        formula = name + u" = α·"_s + name + u"₀ + β·"_s + name + u"₁ + γ·"_s + name + u'₂';
        break;
    }
    const QString toolTip = !scope.isPlanned ? u"%1 at the sample."_s.arg(name)
        : scope.effects.perspective && followsPerspective(which)
        ? u"%1/w at the sample, linear in the frame; %1 itself where it is the same "
          "at all vertices."_s.arg(shadedName(which))
        : which == Channel::Reciprocal
        ? u"1/w at the sample, or 1 where nothing is divided: linear in the frame."_s
        : atSampleText(which) + u'.';
    NumberDescription number
        = comparedNumber(name, name, unitOf(which), toolTip, formula, Group::FirstColour);
    if (!scope.isPlanned && isBilinear(form))
        number.startFormula = direct;
    table.push_back(
        {number, [at = channel.at](const State &state) { return state.linear[at]; },
         [=, at = at, isPlanned = scope.isPlanned](NumberDescription &current, const State &state) {
             if (!isPlanned)
                 specifyValue(current, form, name, state);
             else if (isBilinear(form) && state.startsRun)
                 current.formula = direct;
             if (form == InterpolationForm::Barycentric && state.isCommon[at]
                 && (isPlanned || state.start.hasPlane))
                 current.formula = u"%1 = %1"_s.arg(name) + vertexDigits[state.commonVertex];
         }});
}

/// The quotient by 1/w.
void appendQuotient(Table &table, const ShadedScope &scope, const ScopedChannel &channel)
{
    const Channel which = channel.which;
    const QString &name = shadedName(which);
    table.push_back(
        {comparedNumber(name, name, unitOf(which), atSampleText(which) + u": the quotient."_s,
                        u"%1 = %2/q"_s.arg(name, linearName(which, scope.effects)),
                        Group::FirstColour),
         [at = channel.at](const State &state) { return state.value[at]; },
         [which, linear = linearName(which, scope.effects)](NumberDescription &number,
                                                            const State &state) {
             if (state.isDivided[indexOf(which)])
                 return;
             number.formula = u"%1 = %2"_s.arg(number.title, linear);
             number.toolTip = atSampleText(which) + u'.';
         }});
}

void appendDepth(Table &table, const ShadedScope &scope)
{
    const bool hasLevels = scope.effects.depth == DepthTest::Levels;
    appendPlain(
        table, "z_near", "The nearest depth so far at the pixel; none where nothing stands.", {},
        [](const State &state) { return state.nearest; }, Group::Span);
    table.back().description.comparison = Comparison::WithExact;
    if (!hasLevels)
        return;
    table.push_back(
        {plainNumber("z_level", "z_level", {}, "z as the depth buffer keeps it.", {}, Group::Span),
         [](const State &state) { return state.depth; },
         [most = scope.greatestDepth](NumberDescription &number, const State &state) {
             const Quantity &z = state.linear[indexOf(Channel::Depth)];
             if (z.isNone() || !std::isfinite(z.toDouble()))
                 return;
             const bool isWithin = z.toDouble() >= 0 && z.toDouble() <= 1;
             number.formula
                 = u"z_level = ⌊%1·%2 + ½⌋"_s.arg(isWithin ? u"z"_s : u"min(1, max(0, z))"_s)
                       .arg(most);
         }});
}

} // namespace

void appendPlain(NumberTable<ShadedSampleState> &table, const QString &id, const QString &toolTip,
                 const QString &formula, const ReadOfSample &read, NumberGroup group)
{
    table.push_back({plainNumber(id, id, {}, toolTip, formula, group), read});
}

void appendBytes(NumberTable<ShadedSampleState> &table, const QString &name, const QString &toolTip,
                 const QString &formula, const ColourOfSample &read,
                 const FormulaOfSample &formulaIn)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QString(channelLetters[i]);
        const QString title = name + u'_' + letter;
        table.push_back({plainNumber(title, title, {}, QString(toolTip).replace(u'%', letter),
                                     QString(formula).replace(u'%', letter), Group::FirstColour),
                         ofWritten([=](const State &state) {
                             const std::optional<Colour> colour = read(state);
                             return colour ? Quantity::integer(colour->channels[i]) : Quantity();
                         }),
                         [=](NumberDescription &number, const State &state) {
                             const QString own = formulaIn ? formulaIn(state) : QString();
                             if (!own.isEmpty())
                                 number.formula = QString(own).replace(u'%', letter);
                         }});
    }
}

ReadOfSample ofWritten(const ReadOfSample &read)
{
    return [read](const ShadedSampleState &state) {
        return state.isWritten && state.samples() == 0 ? read(state) : Quantity();
    };
}

NumberTable<ShadedSampleState> shadedSampleNumbers(const ShadedScope &scope)
{
    Table table;
    const EffectSet &effects = scope.effects;
    if (scope.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            table.push_back(
                {comparedNumber(
                     weightId(i), weightTitle(i), {},
                     u"Weight of P%1: 1 there, 0 on the line through the other two."_s.arg(
                         vertexDigits[i]),
                     u"%1 = a_%1·x + b_%1·y + c_%1"_s.arg(weightTitle(i)), Group::Decision),
                 [i](const State &state) { return state.weight[i]; }});
    }
    for (const ScopedChannel &channel : scope.channels)
        appendLinear(table, scope, channel);
    if (!scope.isPlanned)
        return table;
    for (const ScopedChannel &channel : scope.channels) {
        if (effects.perspective && followsPerspective(channel.which))
            appendQuotient(table, scope, channel);
    }
    if (effects.perspective && effects.texture) {
        for (std::size_t i = 0; i < 2; ++i) {
            appendPlain(table, i == 0 ? u"u_affine"_s : u"v_affine"_s,
                        u"What %1 would be without perspective."_s.arg(i == 0 ? u"u"_s : u"v"_s),
                        {}, [i](const State &state) { return state.affine[i]; });
            table.back().description.comparison = Comparison::WithExact;
        }
    }
    if (effects.depth != DepthTest::None)
        appendDepth(table, scope);
    if (effects.texture || effects.light)
        appendBytes(
            table, "base", "% interpolated, as a byte.", {},
            [](const State &state) { return state.interpolated; },
            [rounding = scope.rounding](const State &state) {
                return bytesFormula(state, rounding, "base_% = ");
            });
    if (effects.texture)
        appendTexels(table, scope);
    if (effects.light)
        appendLight(table, scope);
    appendPixel(table, scope);
    return table;
}

} // namespace pixelplumb
