// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/studentwalk.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <functional>

namespace pixelplumb {

namespace {

using Fraction = boost::multiprecision::cpp_rational;
using Whole = boost::multiprecision::cpp_int;

int floorOf(const Fraction &number)
{
    const Whole below = numerator(number) / denominator(number);
    return int(below) - (number < Fraction(below) ? 1 : 0);
}

int ceilOf(const Fraction &number) { return -floorOf(-number); }

/// As (int) casts.
Fraction cast(const Fraction &number)
{
    return Fraction(Whole(numerator(number) / denominator(number)));
}

struct Corner {
    Fraction x, y;
    std::array<Fraction, 3> colour;
};

using Paint = std::function<void(int span, int sample, Colour colour)>;

struct Bound {
    Fraction y;
    std::array<Fraction, 3> colour;
};

class ColumnLoops {
public:
    explicit ColumnLoops(const std::set<WalkMistake> &mistakes)
        : m_mistakes(mistakes)
    {
    }

    /// Corners by x; of rows x and y have changed places.
    void draw(std::array<Corner, 3> corners, const Paint &paint)
    {
        const std::array<Corner, 3> given = corners;
        std::stable_sort(corners.begin(), corners.end(), [](const Corner &a, const Corner &b) {
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
        const bool isMiddleBelow = (p1.y - p0.y) * (p2.x - p0.x) <= (p2.y - p0.y) * (p1.x - p0.x);
        for (int x = begin; x < std::min(endOfFirst, end); ++x)
            drawSpan(x, edgeAt(p0, p1, x), edgeAt(p0, p2, x), isMiddleBelow, paint);
        for (int x = beginOfSecond; x < end; ++x)
            drawSpan(x, edgeAt(p1, p2, x), edgeAt(p0, p2, x), isMiddleBelow, paint);
    }

private:
    bool has(WalkMistake mistake) const { return m_mistakes.contains(mistake); }

    Bound edgeAt(const Corner &from, const Corner &to, int x) const
    {
        Fraction width = to.x - from.x;
        if (width == 0)
            return {from.y, from.colour};
        if (has(WalkMistake::EdgeDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::EdgeDivisorPlusOne))
            width += 1;
        if (width <= 0)
            return {from.y, from.colour};
        Fraction way = x - from.x;
        if (has(WalkMistake::NoEdgePreStep))
            way = x - ceilOf(from.x);
        Fraction slope = (to.y - from.y) / width;
        if (has(WalkMistake::WholeSlopes))
            slope = cast(slope);
        Bound bound{from.y + way * slope, {}};
        if (has(WalkMistake::NoEdgeColourPreStep))
            way = x - ceilOf(from.x);
        for (std::size_t i = 0; i < 3; ++i) {
            Fraction step = (to.colour[i] - from.colour[i]) / width;
            if (has(WalkMistake::WholeEdgeColours))
                step = cast(step);
            bound.colour[i] = from.colour[i] + way * step;
        }
        return bound;
    }

    void drawSpan(int x, const Bound &ofShort, const Bound &ofLong, bool isMiddleBelow,
                  const Paint &paint) const
    {
        const bool isShortLower = ofShort.y != ofLong.y ? ofShort.y < ofLong.y : isMiddleBelow;
        const Bound &lower = isShortLower ? ofShort : ofLong;
        const Bound &upper = isShortLower ? ofLong : ofShort;
        const int first = ceilOf(lower.y);
        const int last = floorOf(upper.y);
        Fraction height = upper.y - lower.y;
        if (has(WalkMistake::SpanDivisorPlusOne))
            height += 1;
        Fraction preStep = first - lower.y;
        if (has(WalkMistake::ColoursBetweenSamples)) {
            height = last - first;
            preStep = 0;
        }
        for (int y = first; y <= last; ++y) {
            Colour colour;
            for (std::size_t i = 0; i < 3; ++i) {
                const Fraction step
                    = height == 0 ? Fraction(0) : (upper.colour[i] - lower.colour[i]) / height;
                const Fraction atFirst
                    = preStep * (has(WalkMistake::WholePreSteps) ? cast(step) : step);
                const Fraction behind
                    = (y - first) * (has(WalkMistake::WholeSteps) ? cast(step) : step);
                const Fraction level = lower.colour[i] + (height == 0 ? 0 : atFirst) + behind;
                colour.channels[i]
                    = std::uint8_t(std::clamp(floorOf(level + Fraction(1, 2)), 0, 255));
            }
            paint(x, y, colour);
        }
    }

    const std::set<WalkMistake> &m_mistakes;
};

} // namespace

Picture studentPicture(const Scene &scene, WalkLines lines, const std::set<WalkMistake> &mistakes)
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
        std::array<Corner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex &vertex = triangle.vertices[i];
            const Fraction x(vertex.position.x, unitsPerPixel);
            const Fraction y(vertex.position.y, unitsPerPixel);
            corners[i].x = onward * (goesByRows ? y : x);
            corners[i].y = goesByRows ? x : y;
            for (std::size_t channel = 0; channel < 3; ++channel)
                corners[i].colour[channel] = int(vertex.colour.channels[channel]);
        }
        ColumnLoops(mistakes).draw(corners, paint);
    }
    return picture;
}

} // namespace pixelplumb
