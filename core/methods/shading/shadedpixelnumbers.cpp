// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/methods/words/placenumbers.h"
#include "core/methods/words/samplesums.h"

#include <cmath>
#include <optional>

namespace pixelplumb {

namespace {

using Group = NumberGroup;
using State = ShadedSampleState;
using Table = NumberTable<State>;

/// "⌊R + ½⌋"
QString roundedText(const QString &level, ByteRounding rounding)
{
    return u'⌊' + level + (rounding == ByteRounding::Nearest ? u" + ½⌋"_s : u"⌋"_s);
}

/// What is painted: the colour as the last stage left it.
void appendSource(Table &table, const EffectSet &ofScope, ByteRounding rounding)
{
    const bool hasBase = ofScope.texture || ofScope.light;
    const QString surface = ofScope.texture ? u"s_% = mod_%"_s
        : ofScope.light                     ? u"s_% = base_%"_s
                                            : QString();
    appendBytes(
        table, "s", "% that is painted.", surface, [](const State &state) { return state.source; },
        [=](const State &state) {
            if (state.effects.light)
                return u"s_% = min(255, ⌊I_% + ½⌋)"_s;
            return hasBase ? QString() : bytesFormula(state, rounding, "s_% = ");
        });
}

void appendBlending(Table &table, const ShadedScope &scope)
{
    table.push_back({plainNumber("a", "a", {}, "Alpha as a byte.", {}, Group::FirstColour),
                     ofWritten([](const State &state) {
                         return state.isBlended ? Quantity::integer(state.alpha) : Quantity();
                     }),
                     [rounding = scope.rounding](NumberDescription &number, const State &state) {
                         const QString byte = state.isWritten
                             ? shadedByteFormula(state, {indexOf(Channel::Alpha)}, rounding)
                             : QString();
                         if (!byte.isEmpty())
                             number.formula = u"a = "_s + QString(byte).replace(u'%', u'A');
                     }});
    QString alpha = "a";
    if (scope.antialiasing == Antialiasing::Area) {
        table.push_back(
            {comparedNumber("area", "area", {},
                            "What of the pixel's square the triangle covers; none inside of it.",
                            {}, Group::FirstColour),
             ofWritten([](const State &state) { return state.area; })});
        alpha = "a_area";
        table.push_back({plainNumber(alpha, alpha, {}, "Alpha times the covered area, as a byte.",
                                     "a_area = ⌊a·area + ½⌋", Group::FirstColour),
                         ofWritten([](const State &state) {
                             return state.isBlended ? Quantity::integer(state.blendedAlpha)
                                                    : Quantity();
                         }),
                         [](NumberDescription &number, const State &state) {
                             if (state.area.isNone())
                                 number.formula = "a_area = a";
                         }});
    }
    appendBytes(table, "d", "% that stood there.", {},
                [](const State &state) { return state.before; });
    appendBytes(
        table, "r", "% of the pixel now.",
        u"r_% = ⌊(s_%·@ + d_%·(255 − @))/255 + ½⌋"_s.replace(u'@', alpha),
        [](const State &state) { return state.after; },
        [](const State &state) { return state.isBlended ? QString() : u"r_% = s_%"_s; });
}

void appendSamples(Table &table, std::size_t samples)
{
    appendPlain(
        table, "samples",
        "How many samples of the pixel this triangle has written; none where the pixel has one.",
        {},
        [](const State &state) {
            return state.samples() == 0
                ? Quantity()
                : Quantity::integer(__builtin_popcount(state.samplesWritten));
        },
        Group::Span);
    appendSampleSums(table,
                     [](const State &state) -> const PixelSamples & { return state.pixelSamples; });
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QString(QChar(channelLetters[i]));
        appendPlain(table, u"mean_"_s + letter,
                    u"The mean of %1 over the pixel's samples, as a byte."_s.arg(letter),
                    u"mean_%1 = ⌊sum_%1/%2 + ½⌋"_s.arg(letter).arg(samples),
                    [i](const State &state) {
                        return state.samples() == 0 ? Quantity()
                                                    : Quantity::integer(state.after.channels[i]);
                    });
    }
}

} // namespace

QString shadedByteFormula(const ShadedSampleState &state,
                          std::initializer_list<std::size_t> channels, ByteRounding rounding)
{
    QString text = roundedText("%", rounding);
    bool isClamped = false;
    for (const std::size_t channel : channels) {
        const Quantity &level = state.interpolatedIn(channel);
        if (level.isNone() || !std::isfinite(level.toDouble()))
            return {};
        isClamped = isClamped || level.toDouble() < 0 || level.toDouble() > 255;
    }
    return isClamped ? u"min(255, max(0, "_s + text + u"))"_s : text;
}

QString bytesFormula(const ShadedSampleState &state, ByteRounding rounding, const QString &name)
{
    const QString byte = shadedByteFormula(state, {0, 1, 2}, rounding);
    return byte.isEmpty() ? byte : name + byte;
}

void appendPixel(NumberTable<ShadedSampleState> &table, const ShadedScope &scope)
{
    const EffectSet &effects = scope.effects;
    if (effects.light || effects.blending)
        appendSource(table, effects, scope.rounding);
    if (effects.blending)
        appendBlending(table, scope);
    if (const std::size_t samples = samplePattern(scope.antialiasing).size(); samples > 0)
        appendSamples(table, samples);
}

} // namespace pixelplumb
