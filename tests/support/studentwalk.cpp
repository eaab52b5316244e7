// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/studentwalk.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pixelplumb {

namespace {

using Fraction = boost::multiprecision::cpp_rational;
using Whole = boost::multiprecision::cpp_int;

int floorOf(double number) { return int(std::clamp(std::floor(number), -1e9, 1e9)); }

int floorOf(const Fraction &number)
{
    const Whole below = numerator(number) / denominator(number);
    return int(below) - (number < Fraction(below) ? 1 : 0);
}

template <class Number>
int ceilOf(const Number &number)
{
    return -floorOf(Number(-number));
}

/// As (int) casts.
template <class Number>
Number cast(const Number &number)
{
    return Number(number < 0 ? ceilOf(number) : floorOf(number));
}

template <class Number>
struct Corner {
    Number x, y;
    std::array<Number, 3> colour;
};

using Paint = std::function<void(int span, int sample, Colour colour)>;

/// Where an edge meets a span, and what is added from span to span.
template <class Number>
struct Bound {
    Number y, slope = 0;
    std::array<Number, 3> colour, step = {};
};

template <class Number>
class ColumnLoops {
public:
    /// Spans' coordinates are those of the program, or their opposites (onward = −1).
    ColumnLoops(const std::set<WalkMistake> &mistakes, int onward)
        : m_mistakes(mistakes)
        , m_onward(onward)
    {
    }

    /// Corners by x; of rows x and y have changed places.
    void draw(std::array<Corner<Number>, 3> corners, const Paint &paint) const
    {
        const std::array<Corner<Number>, 3> given = corners;
        std::stable_sort(corners.begin(), corners.end(), [](const auto &a, const auto &b) {
            return a.x != b.x ? a.x < b.x : a.y < b.y;
        });
        for (std::size_t i = 0; i < 3 && has(WalkMistake::UnsortedColours); ++i)
            corners[i].colour = given[i].colour;
        const auto &[p0, p1, p2] = corners;
        int begin = ceilOf(p0.x);
        if (has(WalkMistake::FirstSpanMissing))
            ++begin;
        if (has(WalkMistake::OpenAtFirstVertex))
            begin = floorOf(p0.x) + 1;
        int endOfFirst = ceilOf(p1.x);
        if (has(WalkMistake::FirstHalfTruncated))
            endOfFirst = floorOf(p1.x);
        int beginOfSecond = std::max(begin, ceilOf(p1.x));
        if (has(WalkMistake::SecondHalfAfterCeiling))
            beginOfSecond = ceilOf(p1.x) + 1;
        if (has(WalkMistake::SecondHalfAfterFloor))
            beginOfSecond = floorOf(p1.x) + 1;
        int end = floorOf(p2.x) + 1;
        if (has(WalkMistake::LastSpanMissing))
            end = floorOf(p2.x);
        if (has(WalkMistake::OpenAtLastVertex))
            end = ceilOf(p2.x);
        if (has(WalkMistake::LoopsTruncated)) {
            begin = truncated(p0.x);
            endOfFirst = truncated(p1.x);
            beginOfSecond = std::max(begin, endOfFirst);
            end = truncated(p2.x) + 1;
        }
        const bool isMiddleBelow = (p1.y - p0.y) * (p2.x - p0.x) <= (p2.y - p0.y) * (p1.x - p0.x);
        Bound<Number> ofLong = edgeAt(p0, p2, begin);
        Bound<Number> ofShort = edgeAt(p0, p1, begin);
        for (int x = begin; x < std::min(endOfFirst, end); ++x) {
            if (!has(WalkMistake::NoFirstHalf))
                drawSpan(x, ofShort, ofLong, isMiddleBelow, paint);
            advance(ofShort);
            advance(ofLong);
        }
        if (beginOfSecond != std::max(begin, endOfFirst))
            ofLong = edgeAt(p0, p2, beginOfSecond);
        ofShort = has(WalkMistake::SecondHalfWithoutPreStep)
            ? edgeAt({Number(ceilOf(p1.x)), p1.y, p1.colour},
                     {p2.x + ceilOf(p1.x) - p1.x, p2.y, p2.colour}, beginOfSecond)
            : edgeAt(p1, p2, beginOfSecond);
        for (int x = beginOfSecond; x < end && !has(WalkMistake::NoSecondHalf); ++x) {
            drawSpan(x, ofShort, ofLong, isMiddleBelow, paint);
            advance(ofShort);
            advance(ofLong);
        }
    }

private:
    bool has(WalkMistake mistake) const { return m_mistakes.contains(mistake); }

    /// (int) of what the program has.
    int truncated(const Number &x) const { return m_onward > 0 ? floorOf(x) : ceilOf(x); }
    Number quotient(const Number &number) const
    {
        return has(WalkMistake::DividesDown) ? Number(floorOf(number)) : cast(number);
    }
    Number stored(const Number &level, WalkMistake mistake) const
    {
        return has(mistake) ? cast(level) : level;
    }
    void advance(Bound<Number> &bound) const
    {
        bound.y += bound.slope;
        for (std::size_t i = 0; i < 3; ++i)
            bound.colour[i] = stored(bound.colour[i] + bound.step[i], WalkMistake::WholeEdgeLevels);
    }

    Bound<Number> edgeAt(const Corner<Number> &from, const Corner<Number> &to, int x) const
    {
        Bound<Number> bound{from.y, 0, from.colour, {}};
        Number width = to.x - from.x;
        if (width == 0)
            return bound;
        if (has(WalkMistake::EdgeDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::EdgeDivisorPlusOne))
            width += 1;
        if (width <= 0)
            return bound;
        Number way = x - from.x;
        if (has(WalkMistake::NoEdgePreStep))
            way = x - ceilOf(from.x);
        if (has(WalkMistake::LoopsTruncated))
            way = x - truncated(from.x);
        bound.slope = (to.y - from.y) / width;
        if (has(WalkMistake::WholeSlopes))
            bound.slope = quotient(bound.slope);
        bound.y += way * bound.slope;
        if (has(WalkMistake::NoEdgeColourPreStep))
            way = x - ceilOf(from.x);
        for (std::size_t i = 0; i < 3; ++i) {
            bound.step[i] = (to.colour[i] - from.colour[i]) / width;
            if (has(WalkMistake::WholeEdgeColours))
                bound.step[i] = quotient(bound.step[i]);
            if (!has(WalkMistake::WholeEdgeLevels)) {
                bound.colour[i] += way * bound.step[i];
                continue;
            }
            const int first = ceilOf(from.x);
            bound.colour[i] = cast(Number(bound.colour[i] + (first - from.x) * bound.step[i]));
            for (int span = first; span < x; ++span)
                bound.colour[i] = cast(Number(bound.colour[i] + bound.step[i]));
        }
        return bound;
    }

    void drawSpan(int x, const Bound<Number> &ofShort, const Bound<Number> &ofLong,
                  bool isMiddleBelow, const Paint &paint) const
    {
        bool isShortLower = ofShort.y != ofLong.y ? ofShort.y < ofLong.y : isMiddleBelow;
        if (has(WalkMistake::LongEdgeAlwaysUpper))
            isShortLower = true;
        if (has(WalkMistake::LongEdgeAlwaysLower))
            isShortLower = false;
        const Bound<Number> &lower = isShortLower ? ofShort : ofLong;
        const Bound<Number> &upper = isShortLower ? ofLong : ofShort;
        const int first = ceilOf(lower.y);
        const int last = floorOf(upper.y);
        Number height = upper.y - lower.y;
        if (has(WalkMistake::SpanDivisorPlusOne))
            height += 1;
        Number preStep = first - lower.y;
        if (has(WalkMistake::ColoursBetweenSamples)) {
            height = last - first;
            preStep = 0;
        }
        std::array<Number, 3> level = lower.colour;
        std::array<Number, 3> step = {};
        for (std::size_t i = 0; i < 3 && height != 0; ++i) {
            const Number rate = (upper.colour[i] - lower.colour[i]) / height;
            level[i] += preStep * (has(WalkMistake::WholePreSteps) ? quotient(rate) : rate);
            step[i] = has(WalkMistake::WholeSteps) ? quotient(rate) : rate;
        }
        for (Number &channel : level)
            channel = stored(channel, WalkMistake::WholeSpanLevels);
        for (int y = first; y <= last; ++y) {
            Colour colour;
            for (std::size_t i = 0; i < 3; ++i) {
                const Number rounded = level[i] + Number(1) / 2;
                colour.channels[i] = std::uint8_t(std::clamp(floorOf(rounded), 0, 255));
                level[i] = stored(level[i] + step[i], WalkMistake::WholeSpanLevels);
            }
            paint(x, y, colour);
        }
    }

    const std::set<WalkMistake> &m_mistakes;
    int m_onward;
};

template <class Number>
Picture pictureIn(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes)
{
    Picture picture{scene.frame.width, scene.frame.height, {}, {}};
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    picture.colours.resize(pixels, scene.frame.background);
    picture.covered.resize(pixels, 0);
    const bool goesByRows = lines == WalkLines::Rows;
    const int onward = goesByRows && !mistakes.contains(WalkMistake::FromBelow) ? -1 : 1;
    const auto paint = [&](int span, int sample, Colour colour) {
        const int x = goesByRows ? sample : span;
        const int y = goesByRows ? onward * span : sample;
        if (x < 0 || x >= picture.width || y < 0 || y >= picture.height)
            return;
        const std::size_t place = picture.placeOf(x, picture.height - 1 - y);
        picture.colours[place] = colour;
        picture.covered[place] = 1;
    };
    for (const Triangle &triangle : scene.triangles) {
        std::array<Corner<Number>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex &vertex = triangle.vertices[i];
            const Number x = Number(vertex.position.x) / unitsPerPixel;
            const Number y = Number(vertex.position.y) / unitsPerPixel;
            corners[i].x = onward * (goesByRows ? y : x);
            corners[i].y = goesByRows ? x : y;
            for (std::size_t channel = 0; channel < 3; ++channel)
                corners[i].colour[channel] = int(vertex.colour.channels[channel]);
        }
        ColumnLoops<Number>(mistakes, onward).draw(corners, paint);
    }
    return picture;
}

} // namespace

Picture studentPicture(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes)
{
    return pictureIn<Fraction>(scene, lines, mistakes);
}

Picture studentPictureInDouble(const Scene &scene, WalkLines lines,
                               const std::set<WalkMistake> &mistakes)
{
    return pictureIn<double>(scene, lines, mistakes);
}

} // namespace pixelplumb
