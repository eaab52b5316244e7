// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/strokenumbers.h"

#include "core/methods/curves/curvenumbers.h"
#include "core/methods/lines/lineendnumbers.h"
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/words/channelnumbers.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/placenumbers.h"
#include "core/methods/words/samplesums.h"

#include <bit>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

NumberDescription strokeNumber(const QString &name, const QString &unit, const QString &toolTip,
                               const QString &formula = {}, Group group = Group::Position)
{
    return plainNumber(name, name, unit, toolTip, formula, group);
}

/// A fraction: its exact one stands beside it.
NumberDescription strokeFraction(const QString &name, const QString &unit, const QString &toolTip,
                                 const QString &formula, Group group)
{
    return comparedNumber(name, name, unit, toolTip, formula, group);
}

bool isLineStroke(const StrokeSetUp &setUp) { return setUp.shape.kind == PrimitiveKind::Line; }

bool isRoundStroke(const StrokeSetUp &setUp)
{
    return setUp.shape.kind == PrimitiveKind::Circle || setUp.shape.kind == PrimitiveKind::Ellipse;
}

/// The ends of a line.
void appendStrokeEnds(NumberTable<StrokeSetUp> &table)
{
    const auto append = [&](QChar letter, std::size_t end, Lattice LatticePoint::*axis) {
        const QString toolTip = end == 0 ? u"of a line's first end."_s : u"of its other end."_s;
        table.push_back(
            endNumber<StrokeSetUp>(letter, int(end), toolTip, [=](const StrokeSetUp &setUp) {
                return isLineStroke(setUp) ? pixels(setUp.shape.vertices[end].position.*axis)
                                           : Quantity();
            }));
    };
    for (const std::size_t end : {0, 1}) {
        append(u'x', end, &LatticePoint::x);
        append(u'y', end, &LatticePoint::y);
    }
}

void appendHalfWidth(NumberTable<StrokeSetUp> &table)
{
    const auto append = [&](QChar letter, const QString &whole, StrokeUnit StrokePoint::*axis) {
        table.push_back({strokeNumber(u"h_"_s + letter, "px",
                                      u"Half of a line's width, ½ px square to it: %1 of "
                                      "%2/(2·√(Δx² + Δy²)), to the nearest 2⁻¹⁶ px."_s.arg(letter)
                                          .arg(whole)),
                         [axis](const StrokeSetUp &setUp) {
                             return isLineStroke(setUp)
                                 ? Quantity::rational(setUp.half.*axis, strokeUnitsPerPixel)
                                 : Quantity();
                         }});
    };
    append(u'x', "−Δy", &StrokePoint::x);
    append(u'y', "Δx", &StrokePoint::y);
}

void appendStrokeColours(NumberTable<StrokeSetUp> &table)
{
    for (const std::size_t end : {0, 1})
        appendChannels(table,
                       plainNumber(u"%_"_s + QString::number(end),
                                   u'%' + QString(QChar(char16_t(u'₀' + end))), "levels",
                                   end == 0 ? u"% of a line's first end, or of the curve."_s
                                            : u"% of a line's other end."_s),
                       [end](const StrokeSetUp &setUp, std::size_t channel) {
                           const std::vector<Vertex> &vertices = setUp.shape.vertices;
                           return end < vertices.size() && (end == 0 || isLineStroke(setUp))
                               ? Quantity::integer(vertices[end].colour.channels[channel])
                               : Quantity();
                       });
}

/// What decides whether a pixel's one sample lies in the rectangle of a line.
void appendDistances(NumberTable<StrokeSampleState> &table)
{
    const auto whole = u"((x₁ − x₀)·h_y − (y₁ − y₀)·h_x)"_s;
    table.push_back(
        {strokeFraction("d_across", "half widths",
                        "How far the sample lies from a line, which covers it from −1 to 1.",
                        u"d_across = ((x₁ − x₀)·(y − y₀) − (y₁ − y₀)·(x − x₀))/"_s + whole,
                        Group::Decision),
         [](const StrokeSampleState &state) { return state.across(); }});
    table.push_back(
        {strokeFraction("d_along", "lengths",
                        "How far along a line the sample lies; from 0 to 1 the line covers it.",
                        u"d_along = ((x − x₀)·h_y − (y − y₀)·h_x)/"_s + whole, Group::Decision),
         [](const StrokeSampleState &state) { return state.along(); }});
}

/// R, G and B of a byte.
void appendStrokeBytes(NumberTable<StrokeSampleState> &table, QChar letter, const QString &toolTip,
                       const QString &formula,
                       const std::function<int(const StrokeSampleState &, std::size_t)> &read)
{
    appendChannels(
        table,
        plainNumber(letter + u"_%"_s, letter + u"_%"_s, {}, toolTip, formula, Group::FirstColour),
        [read](const StrokeSampleState &state, std::size_t channel) {
            return state.isRefused ? Quantity() : Quantity::integer(read(state, channel));
        });
}

void appendStrokeSource(NumberTable<StrokeSampleState> &table)
{
    table.push_back(
        {strokeFraction("t", {},
                        "How far along a line the pixel's sample lies, from 0 at its "
                        "first end to 1 at the other.",
                        {}, Group::FirstColour),
         [](const StrokeSampleState &state) { return state.place(); },
         [](NumberDescription &number, const StrokeSampleState &state) {
             const StrokeColour::Place &place = state.sample.place;
             if (!state.isOnLine())
                 return;
             const auto along
                 = u"((x − x₀)·(x₁ − x₀) + (y − y₀)·(y₁ − y₀))/((x₁ − x₀)² + (y₁ − y₀)²)"_s;
             number.formula = u"t = "_s
                 + (place.run > 0 && place.run < place.length ? along
                                                              : u"min(1, max(0, %1))"_s.arg(along));
         }});
    appendChannels(
        table,
        comparedNumber("%", "%", "levels", "% of the stroke at the sample.", {},
                       Group::FirstColour),
        [](const StrokeSampleState &state, std::size_t channel) { return state.level(channel); },
        [](NumberDescription &number, const StrokeSampleState &state) {
            number.formula = state.isOnLine() ? u"% = %₀ + t·(%₁ − %₀)"_s : u"% = %₀"_s;
        });
    appendChannels(
        table, plainNumber("s_%", "s_%", {}, "% that is painted.", {}, Group::FirstColour),
        [](const StrokeSampleState &state, std::size_t channel) {
            return state.isRefused ? Quantity() : Quantity::integer(state.sample.level[channel]);
        },
        [](NumberDescription &number, const StrokeSampleState &state) {
            number.formula
                = state.rounding == ByteRounding::Nearest ? u"s_% = ⌊% + ½⌋"_s : u"s_% = ⌊%⌋"_s;
        });
}

/// How a pixel's byte is computed.
QString writtenFormula(Antialiasing antialiasing)
{
    if (antialiasing == Antialiasing::Area)
        return u"r_% = ⌊(s_%·a + d_%·(255 − a))/255 + ½⌋"_s;
    const std::size_t samples = samplePattern(antialiasing).size();
    return samples == 0 ? u"r_% = s_%"_s : u"r_% = ⌊sum_%/%1 + ½⌋"_s.arg(samples);
}

} // namespace

const NumberTable<StrokeSetUp> &strokeSetUpNumbers()
{
    static const auto numbers = [] {
        NumberTable<StrokeSetUp> table;
        appendStrokeEnds(table);
        appendHalfWidth(table);
        for (const NumberRow<Round> &row : roundSetUpNumbers())
            table.push_back({row.description, [read = row.read](const StrokeSetUp &setUp) {
                                 return isRoundStroke(setUp) ? read(Round::of(setUp.shape))
                                                             : Quantity();
                             }});
        table.push_back(
            {strokeNumber(
                 "pieces", {},
                 "Quadrilaterals of the whole stroke: one of a line; 0 where it has no length."),
             [](const StrokeSetUp &setUp) { return Quantity::integer(setUp.pieces); }});
        table.push_back(
            {strokeNumber("near", {}, "Those of them that come near the frame."),
             [](const StrokeSetUp &setUp) { return Quantity::integer(setUp.nearFrame); }});
        appendStrokeColours(table);
        return table;
    }();
    return numbers;
}

const NumberTable<StrokeColumn> &strokeColumnNumbers()
{
    static const NumberTable<StrokeColumn> numbers = {
        {scannedNumber(), [](const StrokeColumn &column) { return Quantity::integer(column.x); }},
        {strokeNumber("y_first", "px", "The first row whose square the stroke meets.", {},
                      Group::Span),
         [](const StrokeColumn &column) { return Quantity::integer(column.firstRow); }},
        {strokeNumber("y_last", "px", "The last row whose square it meets.", {}, Group::Span),
         [](const StrokeColumn &column) { return Quantity::integer(column.endRow - 1); }}};
    return numbers;
}

NumberTable<StrokeSampleState> strokeSampleNumbers(Antialiasing antialiasing)
{
    NumberTable<StrokeSampleState> table
        = {{pixelY(), [](const StrokeSampleState &state) { return Quantity::integer(state.y); }}};
    if (antialiasing == Antialiasing::Area) {
        table.push_back(
            {comparedNumber("area", "area", "px²", "What of the pixel's square the stroke covers.",
                            {}, Group::Decision),
             [](const StrokeSampleState &state) { return state.sample.area; }});
        table.push_back(
            {strokeNumber("a", {}, "That area as an opacity, a byte.", "a = ⌊255·area + ½⌋",
                          Group::Decision),
             [](const StrokeSampleState &state) { return Quantity::integer(state.sample.alpha); }});
    } else {
        table.push_back(
            {strokeNumber("samples", {}, "How many samples of the pixel the stroke covers.", {},
                          Group::Decision),
             [](const StrokeSampleState &state) {
                 return Quantity::integer(std::popcount(state.sample.covered));
             }});
    }
    const std::size_t samples = samplePattern(antialiasing).size();
    if (antialiasing == Antialiasing::None)
        appendDistances(table);
    if (samples > 0)
        appendSampleSums(table, [](const StrokeSampleState &state) -> const PixelSamples & {
            return state.sample.current;
        });
    else
        appendStrokeSource(table);
    appendStrokeBytes(table, u'd', "% that stood there.", {},
                      [](const StrokeSampleState &state, std::size_t channel) {
                          return unpacked(state.sample.before).channels[channel];
                      });
    appendStrokeBytes(
        table, u'r',
        samples == 0 ? u"% of the pixel now."_s : u"% of the pixel now: the mean of its samples."_s,
        writtenFormula(antialiasing), [](const StrokeSampleState &state, std::size_t channel) {
            return unpacked(state.sample.after).channels[channel];
        });
    return table;
}

} // namespace pixelplumb
