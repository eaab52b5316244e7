// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/strokenumbers.h"
#include "core/methods/words/formulatext.h"

#include <QStringList>

#include <cmath>

namespace pixelplumb {

namespace {

Int128 crossOf(const StrokePoint &a, const StrokePoint &b)
{
    return Int128(a.x) * b.y - Int128(a.y) * b.x;
}

StrokePoint strokePoint(const LatticePoint &point)
{
    return {point.x * strokeUnitsPerLattice, point.y * strokeUnitsPerLattice};
}

StrokePoint from(const LatticePoint &start, const LatticePoint &end)
{
    return strokePoint({end.x - start.x, end.y - start.y});
}

/// From a line's first end: to its other one, and to a place beside the pixel's sample.
std::pair<StrokePoint, StrokePoint> fromStartOf(const StrokeSampleState &state,
                                                const LatticePoint &offset)
{
    const auto &ends = state.setUp.shape.vertices;
    const LatticePoint there
        = {state.x * unitsPerPixel + offset.x, state.y * unitsPerPixel + offset.y};
    return {from(ends[0].position, ends[1].position), from(ends[0].position, there)};
}

} // namespace

Quantity StrokeSampleState::across(const LatticePoint &offset) const
{
    if (setUp.shape.kind != PrimitiveKind::Line)
        return {};
    const auto [line, there] = fromStartOf(*this, offset);
    return Quantity::rational(crossOf(line, there), crossOf(line, setUp.half));
}

Quantity StrokeSampleState::along(const LatticePoint &offset) const
{
    if (setUp.shape.kind != PrimitiveKind::Line)
        return {};
    const auto [line, there] = fromStartOf(*this, offset);
    return Quantity::rational(crossOf(there, setUp.half), crossOf(line, setUp.half));
}

Quantity StrokeSampleState::place() const
{
    return isOnLine() && !isRefused ? Quantity::rational(sample.place.run, sample.place.length)
                                    : Quantity();
}

Quantity StrokeSampleState::level(std::size_t channel) const
{
    if (isMean() || isRefused)
        return {};
    const Int128 from = setUp.shape.vertices.front().colour.channels[channel];
    if (!isOnLine())
        return Quantity::integer(from);
    const Int128 to = setUp.shape.vertices.back().colour.channels[channel];
    const StrokeColour::Place &place = sample.place;
    return Quantity::rational(from * place.length + (to - from) * place.run, place.length);
}

namespace {

bool isOnBorder(double across, double along)
{
    return std::abs(across) == 1 || along == 0 || along == 1;
}

/// Where a sample lies, as far as that decides: beyond a line's end, or so far from the line.
QString placeText(const StrokeSampleState &state, const LatticePoint &offset)
{
    const Quantity across = state.across(offset);
    const Quantity along = state.along(offset);
    if (across.isNone())
        return {};
    if (along.toDouble() < 0 || along.toDouble() > 1)
        return u", which lies beyond its end: d_along = %1"_s.arg(term(along));
    const QString lies = u", which lies %1 half widths from the line"_s.arg(term(across));
    return isOnBorder(across.toDouble(), along.toDouble()) ? lies
            + u" on the border of its rectangle, where it counts as displaced to the "
              "right and, by less, up"_s
                                                           : lies;
}

/// Where the samples lie that a line does not cover.
QString uncoveredText(const StrokeSampleState &state)
{
    if (!state.isOnLine())
        return {};
    const auto pattern = samplePattern(state.sample.samples == 4 ? Antialiasing::Samples4
                                                                 : Antialiasing::Samples16);
    QStringList texts;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if ((state.sample.covered >> i & 1U) != 0)
            continue;
        const Quantity along = state.along(pattern[i]);
        const bool isBeyondEnd = along.toDouble() < 0 || along.toDouble() > 1;
        texts += u"%1 at %2"_s.arg(i + 1).arg(isBeyondEnd ? u"d_along = "_s + term(along)
                                                          : u"d_across = "_s
                                                      + term(state.across(pattern[i])));
    }
    return texts.isEmpty()
        ? QString()
        : u" The line covers d_across from −1 to 1 half widths and d_along from 0 to "
          "1 of its length, a sample on that border as if displaced towards "
          "larger x and, by less, larger y; outside lie the samples "_s
            + texts.join(u", "_s) + u'.';
}

} // namespace

void tellStroke(StepWords &words, const StrokeSetUp &setUp)
{
    if (setUp.pieces == 0) {
        words.sentence = "It has no length, and so no area. Nothing is drawn.";
        return;
    }
    words.sentence = setUp.shape.kind == PrimitiveKind::Line
        ? u"The line is the rectangle ½ px to either side of it, which ends where "
          "the line ends; its corners are the ends and, to 2⁻¹⁶ px, the half width."_s
        : u"The curve is a strip of %1 quadrilaterals ½ px to either side of its "
          "points, of which %2 come near the frame."_s.arg(setUp.pieces)
              .arg(setUp.nearFrame);
}

void tellStroke(StepWords &words, const StrokeColumn &column)
{
    const std::int64_t last = column.endRow - 1;
    words.sentence = last == column.firstRow
        ? u"In this column the stroke meets the square of the row %1."_s.arg(last)
        : u"In this column the stroke meets the squares of rows from %1 to %2."_s
              .arg(column.firstRow)
              .arg(last);
}

void tellStroke(StepWords &words, const StrokeSampleState &state)
{
    const StrokeSample &sample = state.sample;
    if (state.isByArea()) {
        words.sentence
            = u"The stroke covers %1 of the pixel's square, which is its opacity: %2 "
              "of 255 parts are the stroke's, the others what stood there."_s.arg(term(sample.area))
                  .arg(sample.alpha);
        return;
    }
    if (sample.samples == 1) {
        const QString lies = placeText(state, {});
        words.sentence = state.isRefused
            ? u"Refused: the stroke does not cover the pixel's sample"_s + lies + u'.'
            : u"The stroke covers the pixel's sample"_s + lies + u": it is painted."_s;
        return;
    }
    if (state.isRefused) {
        words.sentence
            = u"Refused: the stroke covers none of the pixel's %1 samples."_s.arg(sample.samples)
            + uncoveredText(state);
        return;
    }
    words.sentence
        = u"Of the pixel's %2 samples the stroke covers %1; the pixel is "
          "the mean of what they hold now."_s.arg(sampleNumbersText(sample.covered, sample.samples))
              .arg(sample.samples)
        + uncoveredText(state);
}

} // namespace pixelplumb
