// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/byteexplanation.h"

#include "core/methods/edgewalknames.h"
#include "core/methods/words/formulatext.h"
#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array channelSubjects
    = {NumberSubject::Red, NumberSubject::Green, NumberSubject::Blue};

/// "⌊R + ½⌋", with the clamp where it was needed; % stands for the channel. A float kernel
/// truncates towards zero: below zero its level is 0 where the floor is −1. `bias` is what the
/// kernel adds, in symbols; usually nothing.
QString byteFormula(ByteRounding rounding, const Quantity &channel, std::int64_t level,
                    const QString &bias)
{
    const bool isNearest = rounding == ByteRounding::Nearest;
    const QString nearest = bias.isEmpty() ? u"½"_s : u"(½ + %1)"_s.arg(bias);
    const QString added = isNearest ? nearest : bias;
    const QString rounded = added.isEmpty() ? u"⌊%⌋"_s : u"⌊% + %1⌋"_s.arg(added);
    if (level < 0 || channel.toDouble() + (isNearest ? 0.5 : 0.0) < 0)
        return u"max(0, "_s + rounded + u')';
    return level > 255 ? u"min(255, "_s + rounded + u')' : rounded;
}

/// The sample's number with this title; none if there is none.
Quantity numberTitled(const QString &title, const std::vector<NumberDescription> &columns,
                      const std::vector<Quantity> &used)
{
    const auto column = std::ranges::find(columns, title, &NumberDescription::title);
    const auto place = std::size_t(column - columns.begin());
    return place < used.size() ? used[place] : Quantity();
}

/// What the kernel adds to levels before it truncates them; none if it adds nothing.
Quantity biasIn(const WrittenSample &written)
{
    const Quantity bias = numberTitled(colourBiasTitle(), written.numbers, written.sample.cells);
    return !bias.isNone() && bias.toDouble() != 0 ? bias : Quantity();
}

/// Enough digits for the reader to check the sum.
int placesOfSum(const Quantity &level, const Quantity &bias)
{
    return bias.isNone()
        ? usualPlaces
        : placesOfOperands(Quantity::of(level.toDouble() + (0.5 + bias.toDouble())));
}

/// The byte of an exact level.
Quantity byteOf(const Quantity &level, ByteRounding rounding)
{
    const CommonFraction exact{level.numerator(), level.denominator()};
    const Int128 byte = rounding == ByteRounding::Nearest ? exact.nearest() : exact.floor();
    return Quantity::integer(std::clamp<Int128>(byte, 0, 255));
}

/// The last stage of a sample's effects that changed the colour: "r", "s", "mod"; empty if none
/// did.
QString lastStage(const std::vector<NumberDescription> &columns, const std::vector<Quantity> &used)
{
    for (const char *stage : {"mean", "r", "s", "mod"}) {
        if (!numberTitled(stage + u"_R"_s, columns, used).isNone())
            return stage;
    }
    return {};
}

/// The bytes written to the pixel: those of the last stage.
void appendStage(Explanation &explanation, const QString &stage, QRgb pixel)
{
    const Colour colour = unpacked(pixel);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Quantity byte = Quantity::integer(colour.channels[channel]);
        explanation.lines.push_back({channelSubjects[channel],
                                     u"byte = %1_%2"_s.arg(stage).arg(channelLetters[channel]),
                                     term(byte),
                                     byte,
                                     {}});
    }
}

/// The bytes of the levels, and the levels themselves if no column describes them.
void appendRounding(Explanation &explanation, ByteRounding rounding, const WrittenSample &written)
{
    const SampleRecord &sample = written.sample;
    const ExactSample &exact = written.exact;
    const Quantity bias = biasIn(written);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (sample.colour[channel].isNone())
            continue;
        const int places = placesOfSum(sample.colour[channel], bias);
        const auto filled = [&](const QString &level, const QString &added) {
            return byteFormula(rounding, sample.colour[channel], sample.level[channel],
                               bias.isNone() ? QString() : added)
                .replace(u'%', level);
        };
        FormulaLine byte;
        byte.subject = channelSubjects[channel];
        byte.symbols = u"byte = "_s + filled(QString(channelLetters[channel]), colourBiasTitle());
        byte.substituted = filled(term(sample.colour[channel], places), term(bias, places));
        byte.used = Quantity::integer(std::clamp<std::int64_t>(sample.level[channel], 0, 255));
        if (exact.colour[channel].isRational())
            byte.exact = byteOf(exact.colour[channel], rounding);
        explanation.lines.push_back(byte);
    }
}

} // namespace

void appendBytes(Explanation &explanation, const TracedScene &traced, const WrittenSample &written)
{
    const QString stage = lastStage(written.numbers, written.sample.cells);
    if (stage.isEmpty())
        appendRounding(explanation, traced.scene.settings.rounding, written);
    else
        appendStage(explanation, stage, written.pixel);
}

} // namespace pixelplumb
