// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/shadednumbers.h"
#include "core/methods/units.h"

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;
using State = ShadedSampleState;
using Table = NumberTable<State>;
using Read = ReadOfSample;

void append(Table &table, const QString &id, const QString &toolTip, const QString &formula,
            const Read &read, Group group = Group::FirstColour)
{
    table.push_back({plainNumber(id, id, {}, toolTip, formula, group), read});
}

/// What a sample has in a channel, linear in the frame.
void appendLinear(Table &table, const ShadedScope &scope, std::size_t channel)
{
    const Channel which = channelAt(channel);
    const QString name = linearName(which, scope.effects);
    const QString direct = QStringLiteral("%1 ← %2 + (y − y_B)·Δ%1")
                               .arg(name, withSubscript(name, QStringLiteral("B")));
    QString formula;
    switch (scope.form) {
    case InterpolationForm::Bilinear:
    case InterpolationForm::BilinearRows: // draws no effects
        formula = QStringLiteral("%1 ← %1′ + Δ%1").arg(name);
        break;
    case InterpolationForm::Plane:
        formula = QStringLiteral("%1 = %2·x + %3·y + %4")
                      .arg(name, coefficientOf(QStringLiteral("a"), name),
                           coefficientOf(QStringLiteral("b"), name),
                           coefficientOf(QStringLiteral("c"), name));
        break;
    case InterpolationForm::Barycentric:
        formula = name + QStringLiteral(" = α·") + name + QStringLiteral("₀ + β·") + name
            + QStringLiteral("₁ + γ·") + name + u'₂';
        break;
    }
    const QString toolTip = scope.effects.perspective && followsPerspective(which)
        ? QStringLiteral("%1/w at the sample: linear in the frame.").arg(shadedName(which))
        : which == Channel::Reciprocal ? QStringLiteral("1/w at the sample: linear in the frame.")
                                       : QStringLiteral("%1 at the sample.").arg(name);
    table.push_back({comparedNumber(name, name, isLevel(which) ? unit::levels() : QString(),
                                    toolTip, formula, Group::FirstColour),
                     [channel](const State &state) { return state.linear[channel]; },
                     [=, isBilinear = scope.form == InterpolationForm::Bilinear](
                         NumberDescription &number, const State &state) {
                         if (isBilinear && state.startsRun)
                             number.formula = direct;
                     }});
}

/// The quotient by 1/w.
void appendQuotient(Table &table, const ShadedScope &scope, std::size_t channel)
{
    const Channel which = channelAt(channel);
    const QString &name = shadedName(which);
    table.push_back(
        {comparedNumber(name, name, isLevel(which) ? unit::levels() : QString(),
                        QStringLiteral("%1 at the sample: the quotient.").arg(name),
                        QStringLiteral("%1 = %2/q").arg(name, linearName(which, scope.effects)),
                        Group::FirstColour),
         [channel](const State &state) { return state.value[channel]; },
         [linear = linearName(which, scope.effects)](NumberDescription &number,
                                                     const State &state) {
             if (state.effects.perspective)
                 return;
             number.formula = QStringLiteral("%1 = %2").arg(number.title, linear);
             number.toolTip = QStringLiteral("%1 at the sample.").arg(number.title);
         }});
}

void appendDepth(Table &table, const ShadedScope &scope)
{
    const bool hasLevels = scope.effects.depth == DepthTest::Levels;
    append(
        table, QStringLiteral("z_near"),
        QStringLiteral("The nearest depth so far at the pixel; none where nothing stands."), {},
        [](const State &state) { return state.nearest; }, Group::Span);
    if (!hasLevels)
        return;
    table.push_back(
        {plainNumber(QStringLiteral("z_level"), QStringLiteral("z_level"), {},
                     QStringLiteral("z as the depth buffer keeps it."), {}, Group::Span),
         [](const State &state) { return state.depth; },
         [most = scope.greatestDepth](NumberDescription &number, const State &state) {
             const Quantity &z = state.linear[indexOf(Channel::Depth)];
             if (z.isNone() || !std::isfinite(z.toDouble()))
                 return;
             const bool isWithin = z.toDouble() >= 0 && z.toDouble() <= 1;
             number.formula
                 = QStringLiteral("z_level = ⌊%1·%2 + ½⌋")
                       .arg(isWithin ? QStringLiteral("z") : QStringLiteral("min(1, max(0, z))"))
                       .arg(most);
         }});
}

/// "⌊R + ½⌋"
QString roundedText(const QString &level, ByteRounding rounding)
{
    return u'⌊' + level
        + (rounding == ByteRounding::Nearest ? QStringLiteral(" + ½⌋") : QStringLiteral("⌋"));
}

/// How bytes come from the interpolated levels of channels, % standing for each: clamped where one
/// of them leaves 0 … 255; empty where one is no number.
QString byteFormula(const State &state, std::initializer_list<std::size_t> channels,
                    ByteRounding rounding)
{
    QString text = roundedText(QStringLiteral("%"), rounding);
    bool isClamped = false;
    for (const std::size_t channel : channels) {
        const Quantity &level = state.interpolatedIn(channel);
        if (level.isNone() || !std::isfinite(level.toDouble()))
            return {};
        isClamped = isClamped || level.toDouble() < 0 || level.toDouble() > 255;
    }
    return isClamped ? QStringLiteral("min(255, max(0, ") + text + QStringLiteral("))") : text;
}

QString baseFormula(const State &state, ByteRounding rounding, const QString &name)
{
    const QString byte = byteFormula(state, {0, 1, 2}, rounding);
    return byte.isEmpty() ? byte : name + byte;
}

/// What is painted: what the last stage made of the colour.
void appendSource(Table &table, const EffectSet &ofScope, ByteRounding rounding)
{
    const bool hasBase = ofScope.texture || ofScope.light;
    const QString surface = ofScope.texture ? QStringLiteral("s_% = mod_%")
        : ofScope.light                     ? QStringLiteral("s_% = base_%")
                                            : QString();
    appendBytes(
        table, QStringLiteral("s"), QStringLiteral("% that is painted."), surface,
        [](const State &state) { return state.source; },
        [=](const State &state) {
            if (state.effects.light)
                return QStringLiteral("s_% = min(255, ⌊I_% + ½⌋)");
            return hasBase ? QString() : baseFormula(state, rounding, QStringLiteral("s_% = "));
        });
}

void appendBlending(Table &table, const ShadedScope &scope)
{
    table.push_back({plainNumber(QStringLiteral("a"), QStringLiteral("a"), {},
                                 QStringLiteral("Alpha as a byte."), {}, Group::FirstColour),
                     ofWritten([](const State &state) {
                         return state.isBlended ? Quantity::integer(state.alpha) : Quantity();
                     }),
                     [rounding = scope.rounding](NumberDescription &number, const State &state) {
                         const QString byte = state.isWritten
                             ? byteFormula(state, {indexOf(Channel::Alpha)}, rounding)
                             : QString();
                         if (!byte.isEmpty())
                             number.formula
                                 = QStringLiteral("a = ") + QString(byte).replace(u'%', u'A');
                     }});
    QString alpha = QStringLiteral("a");
    if (scope.antialiasing == Antialiasing::Area) {
        append(table, QStringLiteral("area"),
               QStringLiteral("What of the pixel's square the triangle covers; none inside of "
                              "it."),
               {}, ofWritten([](const State &state) { return state.area; }));
        alpha = QStringLiteral("a_area");
        table.push_back({plainNumber(alpha, alpha, {},
                                     QStringLiteral("Alpha times the covered area, as a byte."),
                                     QStringLiteral("a_area = ⌊a·area + ½⌋"), Group::FirstColour),
                         ofWritten([](const State &state) {
                             return state.isBlended ? Quantity::integer(state.blendedAlpha)
                                                    : Quantity();
                         }),
                         [](NumberDescription &number, const State &state) {
                             if (state.area.isNone())
                                 number.formula = QStringLiteral("a_area = a");
                         }});
    }
    appendBytes(table, QStringLiteral("d"), QStringLiteral("% that stood there."), {},
                [](const State &state) { return state.before; });
    appendBytes(
        table, QStringLiteral("r"), QStringLiteral("% of the pixel now."),
        QStringLiteral("r_% = ⌊(s_%·@ + d_%·(255 − @))/255 + ½⌋").replace(u'@', alpha),
        [](const State &state) { return state.after; },
        [](const State &state) {
            return state.isBlended ? QString() : QStringLiteral("r_% = s_%");
        });
}

void appendSamples(Table &table, std::size_t samples)
{
    append(
        table, QStringLiteral("samples"),
        QStringLiteral("How many samples of the pixel this triangle has written; none where the "
                       "pixel has one."),
        {},
        [](const State &state) {
            return state.samples == 0 ? Quantity()
                                      : Quantity::integer(__builtin_popcount(state.samplesWritten));
        },
        Group::Span);
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QString(QChar(channelLetters[i]));
        append(
            table, QStringLiteral("sum_") + letter,
            QStringLiteral("The sum of %1 over the pixel's samples, as they stand now.")
                .arg(letter),
            {},
            [i](const State &state) {
                return state.samples == 0 ? Quantity() : Quantity::integer(state.sampleSum[i]);
            },
            Group::FirstColour);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QString(QChar(channelLetters[i]));
        append(table, QStringLiteral("mean_") + letter,
               QStringLiteral("The mean of %1 over the pixel's samples, as a byte.").arg(letter),
               QStringLiteral("mean_%1 = ⌊sum_%1/%2 + ½⌋").arg(letter).arg(samples),
               [i](const State &state) {
                   return state.samples == 0 ? Quantity()
                                             : Quantity::integer(state.after.channels[i]);
               });
    }
}

} // namespace

NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula, NumberGroup group)
{
    return {.id = id,
            .title = title,
            .unit = unit,
            .toolTip = toolTip,
            .formula = formula,
            .group = group};
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
        return state.isWritten && state.samples == 0 ? read(state) : Quantity();
    };
}

NumberTable<ShadedSampleState> shadedSampleNumbers(const ShadedScope &scope)
{
    Table table;
    const EffectSet &effects = scope.effects;
    if (scope.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            table.push_back(
                {comparedNumber(weightId(i), weightTitle(i), {},
                                QStringLiteral("Weight of P%1: 1 there, 0 on the line through the "
                                               "other two.")
                                    .arg(vertexDigits[i]),
                                QStringLiteral("%1 = a_%1·x + b_%1·y + c_%1").arg(weightTitle(i)),
                                Group::Decision),
                 [i](const State &state) { return state.weight[i]; }});
    }
    forEachChannel(effects, [&](std::size_t channel) { appendLinear(table, scope, channel); });
    if (effects.perspective) {
        forEachChannel(effects, [&](std::size_t channel) {
            if (followsPerspective(channelAt(channel)))
                appendQuotient(table, scope, channel);
        });
    }
    if (effects.perspective && effects.texture) {
        for (std::size_t i = 0; i < 2; ++i)
            append(table, i == 0 ? QStringLiteral("u_affine") : QStringLiteral("v_affine"),
                   QStringLiteral("What %1 would be without perspective.")
                       .arg(i == 0 ? QStringLiteral("u") : QStringLiteral("v")),
                   {}, [i](const State &state) { return state.affine[i]; });
    }
    if (effects.depth != DepthTest::None)
        appendDepth(table, scope);
    if (effects.texture || effects.light)
        appendBytes(
            table, QStringLiteral("base"), QStringLiteral("% interpolated, as a byte."), {},
            [](const State &state) { return state.interpolated; },
            [rounding = scope.rounding](const State &state) {
                return baseFormula(state, rounding, QStringLiteral("base_% = "));
            });
    if (effects.texture)
        appendTexels(table, scope);
    if (effects.light)
        appendLight(table, scope);
    if (effects.light || effects.blending)
        appendSource(table, effects, scope.rounding);
    if (effects.blending)
        appendBlending(table, scope);
    if (const std::size_t samples = samplePattern(scope.antialiasing).size(); samples > 0)
        appendSamples(table, samples);
    return table;
}

} // namespace pixelplumb
