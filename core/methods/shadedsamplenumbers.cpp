// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/shadednumbers.h"
#include "core/methods/units.h"

#include <optional>
#include <utility>

namespace pixelplumb {

namespace {

using Group = NumberGroup;
using State = ShadedSampleState;
using Table = NumberTable<State>;
using Read = ReadOfSample;

NumberDescription plainNumber(const QString &id, const QString &title, const QString &unit,
                              const QString &toolTip, const QString &formula, Group group)
{
    return {.id = id,
            .title = title,
            .unit = unit,
            .toolTip = toolTip,
            .formula = formula,
            .group = group};
}

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
         [channel](const State &state) { return state.value[channel]; }});
}

void appendDepth(Table &table, const ShadedScope &scope)
{
    const bool hasLevels = scope.effects.depth == DepthTest::Levels;
    append(
        table, QStringLiteral("z_near"),
        QStringLiteral("The nearest depth so far at the pixel; none where nothing stands."), {},
        [](const State &state) { return state.nearest; }, Group::Span);
    if (hasLevels)
        append(
            table, QStringLiteral("z_level"), QStringLiteral("z as the depth buffer keeps it."), {},
            [](const State &state) { return state.depth; }, Group::Span);
}

/// R, G and B of bytes: "t_R". `formulaIn` is that of states that have another one.
void appendBytes(Table &table, const QString &name, const QString &toolTip, const QString &formula,
                 const std::function<std::optional<Colour>(const State &)> &read,
                 const std::function<QString(const State &)> &formulaIn = {})
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

/// How a byte comes from the interpolated levels; empty where they are not interpolated, or where
/// one of them is clamped.
QString baseFormula(const State &state, ByteRounding rounding, const QString &name)
{
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Quantity &quotient = state.value[channel];
        const Quantity &level = quotient.isNone() ? state.linear[channel] : quotient;
        if (level.isNone() || level.toDouble() < 0 || level.toDouble() > 255)
            return {};
    }
    return name
        + (rounding == ByteRounding::Nearest ? QStringLiteral("⌊% + ½⌋") : QStringLiteral("⌊%⌋"));
}

/// Whether no texel that is read along a side is wrapped or clamped.
bool liesInside(const State &state, std::size_t side)
{
    const std::size_t channel = indexOf(Channel::U) + side;
    const Quantity &value
        = state.value[channel].isNone() ? state.linear[channel] : state.value[channel];
    if (!state.isWritten || !state.effects.texture || value.isNone())
        return false;
    const double half = state.isFiltered ? 0.5 : 0;
    const double place = value.toDouble() * state.textureSize[side] - half;
    return place >= 0 && place < state.textureSize[side] - 2 * half;
}

bool isFiltered(const State &state)
{
    return state.isWritten && state.effects.texture && state.isFiltered;
}

void appendFourTexels(Table &table)
{
    const std::array names = {QStringLiteral("t00"), QStringLiteral("t10"), QStringLiteral("t01"),
                              QStringLiteral("t11")};
    const std::array places = {QStringLiteral("lower left"), QStringLiteral("lower right"),
                               QStringLiteral("upper left"), QStringLiteral("upper right")};
    for (std::size_t k = 0; k < names.size(); ++k)
        appendBytes(table, names[k],
                    QStringLiteral("% of the %1 of the four texels.").arg(places[k]), {},
                    [k](const State &state) {
                        return isFiltered(state) ? std::optional(state.texels[k]) : std::nullopt;
                    });
}

/// Which texels are read. The formula holds where the place is inside of the texture.
void appendTexels(Table &table, const ShadedScope &scope)
{
    for (std::size_t side = 0; side < 2; ++side) {
        const QString index = side == 0 ? QStringLiteral("i") : QStringLiteral("j");
        const QString coordinate = side == 0 ? QStringLiteral("u") : QStringLiteral("v");
        table.push_back(
            {plainNumber(index, index, {},
                         QStringLiteral("The texel's place along %1, from 0.").arg(coordinate), {},
                         Group::FirstColour),
             ofWritten([side](const State &state) {
                 return state.effects.texture ? Quantity::integer(state.firstTexel[side])
                                              : Quantity();
             }),
             [=](NumberDescription &number, const State &state) {
                 if (!liesInside(state, side))
                     return;
                 const QString half = state.isFiltered ? QStringLiteral(" − ½") : QString();
                 number.formula = QStringLiteral("%1 = ⌊%2·%3%4⌋")
                                      .arg(index)
                                      .arg(state.textureSize[side])
                                      .arg(coordinate, half);
             }});
        if (!scope.isFiltered)
            continue;
        const QString fraction = QStringLiteral("f_") + coordinate;
        table.push_back(
            {plainNumber(fraction, fraction, {},
                         QStringLiteral("How far the sample lies from that texel's centre to the "
                                        "next one's, along %1.")
                             .arg(coordinate),
                         {}, Group::FirstColour),
             ofWritten([side](const State &state) {
                 return isFiltered(state) ? state.fraction[side] : Quantity();
             }),
             [=](NumberDescription &number, const State &state) {
                 if (isFiltered(state) && liesInside(state, side))
                     number.formula = QStringLiteral("%1 = %2·%3 − ½ − %4")
                                          .arg(fraction)
                                          .arg(state.textureSize[side])
                                          .arg(coordinate, index);
             }});
    }
    if (scope.isFiltered)
        appendFourTexels(table);
    appendBytes(
        table, QStringLiteral("t"), QStringLiteral("% of the texel, or of the four."), {},
        [](const State &state) {
            return state.effects.texture ? std::optional(state.texel) : std::nullopt;
        },
        [](const State &state) {
            return isFiltered(state) ? QStringLiteral(
                       "t_% = ⌊(t00_%·(1 − f_u) + t10_%·f_u)·(1 − f_v) + (t01_%·(1 − f_u) "
                       "+ t11_%·f_u)·f_v + ½⌋")
                                     : QString();
        });
    appendBytes(
        table, QStringLiteral("mod"), QStringLiteral("% modulated by the texel."),
        QStringLiteral("mod_% = ⌊base_%·t_%/255 + ½⌋"),
        [](const State &state) { return state.textured; },
        [](const State &state) {
            return state.effects.texture ? QString() : QStringLiteral("mod_% = base_%");
        });
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

/// How alpha's byte comes from the interpolated one; empty where it is not interpolated.
QString alphaFormula(const State &state, ByteRounding rounding)
{
    const std::size_t channel = indexOf(Channel::Alpha);
    const Quantity &level
        = state.value[channel].isNone() ? state.linear[channel] : state.value[channel];
    if (!state.isWritten || level.isNone() || level.toDouble() < 0 || level.toDouble() > 255)
        return {};
    return rounding == ByteRounding::Nearest ? QStringLiteral("a = ⌊A + ½⌋")
                                             : QStringLiteral("a = ⌊A⌋");
}

void appendBlending(Table &table, const ShadedScope &scope)
{
    table.push_back({plainNumber(QStringLiteral("a"), QStringLiteral("a"), {},
                                 QStringLiteral("Alpha as a byte."), {}, Group::FirstColour),
                     ofWritten([](const State &state) {
                         return state.isBlended ? Quantity::integer(state.alpha) : Quantity();
                     }),
                     [rounding = scope.rounding](NumberDescription &number, const State &state) {
                         number.formula = alphaFormula(state, rounding);
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

void appendSamples(Table &table)
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
    for (std::size_t i = 0; i < 3; ++i)
        append(table, QStringLiteral("mean_") + QChar(channelLetters[i]),
               QStringLiteral("The mean of %1 over the pixel's samples, as a byte.")
                   .arg(QChar(channelLetters[i])),
               {}, [i](const State &state) {
                   return state.samples == 0 ? Quantity()
                                             : Quantity::integer(state.after.channels[i]);
               });
}

} // namespace

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
                                QStringLiteral("Weight of vertex %1: 1 there, 0 on the line "
                                               "through the other two.")
                                    .arg(i),
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
            append(
                table, i == 0 ? QStringLiteral("u_affine") : QStringLiteral("v_affine"),
                QStringLiteral("What %1 would be without perspective.").arg(i == 0 ? u'u' : u'v'),
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
    if (!samplePattern(scope.antialiasing).empty())
        appendSamples(table);
    return table;
}

} // namespace pixelplumb
