// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/programline.h"

#include "core/frame/framebuffer.h"
#include "core/grade/scan/drawnline.h"
#include "core/grade/scan/redrawing.h"
#include "core/number/commonfraction.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// A term of the decision; `right` where it is that.
std::int64_t valueOf(DecisionTerm term, DecisionTerm right, std::int64_t dx, std::int64_t dy)
{
    switch (term == DecisionTerm::Right ? right : term) {
    case DecisionTerm::Right:
    case DecisionTerm::Nothing:
        break;
    case DecisionTerm::Rise:
        return dy;
    case DecisionTerm::TwiceRise:
        return 2 * dy;
    case DecisionTerm::Difference:
        return dy - dx;
    case DecisionTerm::TwiceDifference:
        return 2 * dy - 2 * dx;
    case DecisionTerm::Midpoint:
        return 2 * dy - dx;
    case DecisionTerm::MidpointNegated:
        return dx - 2 * dy;
    case DecisionTerm::HalfMidpoint:
        return dy - dx / 2;
    case DecisionTerm::Sum:
        return 2 * dy + dx;
    case DecisionTerm::Exchanged:
        return 2 * dx - dy;
    case DecisionTerm::TwiceRun:
        return 2 * dx;
    case DecisionTerm::RunNegated:
        return -dx;
    case DecisionTerm::TwiceRunNegated:
        return -2 * dx;
    case DecisionTerm::WholeSlope:
        return dy == dx ? 1 : -1;
    }
    return 0;
}

/// A line's coordinates along and across its steps, px.
struct LineEnds {
    std::int64_t fromAlong = 0, fromAcross = 0, toAlong = 0, toAcross = 0;
    bool isSteep = false; ///< x and y are exchanged
};

/// Draws lines one after another, each by its steps.
class LineSteps {
public:
    LineSteps(const LineBugs &bugs, const Scene &scene)
        : m_bugs(bugs)
        , m_settings(scene.settings)
    {
    }

    /// Of a line between samples, after those before it.
    std::vector<LinePixel> pixelsOf(DrawnLine line)
    {
        const bool isSteep = isExchanged(line);
        sortEnds(line, isSteep);
        const LineEnds ends = endsOf(line, isSteep);
        const bool descends = ends.toAlong < ends.fromAlong;
        if (descends && m_bugs.descending == DescendingLine::Lost)
            return {};
        const bool isPixel = descends && m_bugs.descending == DescendingLine::FirstPixelAlone;
        const std::int64_t length = differencesOf(ends).first;
        const std::int64_t last = isPixel ? 0 : lastStep(length);
        const bool goesUp = !descends || m_bugs.descending == DescendingLine::Ascends;
        const std::vector<std::int64_t> across = stepsAcross(ends, last);
        for (std::int64_t step = 0; step <= last; ++step) {
            const std::int64_t x = ends.fromAlong + (goesUp ? step : -step);
            const std::int64_t y = ends.fromAcross + across[std::size_t(step)];
            line.pixels.push_back({isSteep ? y : x, isSteep ? x : y, colourAt(line, step, length)});
        }
        return line.pixels;
    }

private:
    bool isExchanged(const DrawnLine &line) const
    {
        switch (m_bugs.steep) {
        case SteepLine::Exchanged:
        case SteepLine::OwnDifferences:
            return line.isSteep();
        case SteepLine::AsFlat:
            return false;
        case SteepLine::Inverted:
            return !line.isSteep();
        case SteepLine::BySignedDifferences:
            break;
        }
        return line.to.y - line.from.y > line.to.x - line.from.x;
    }
    static LineEnds endsOf(const DrawnLine &line, bool isSteep)
    {
        LineEnds ends{floorPixel(line.from.x), floorPixel(line.from.y), floorPixel(line.to.x),
                      floorPixel(line.to.y), isSteep};
        if (isSteep) {
            std::swap(ends.fromAlong, ends.fromAcross);
            std::swap(ends.toAlong, ends.toAcross);
        }
        return ends;
    }
    void sortEnds(DrawnLine &line, bool isSteep) const
    {
        const bool isLeft = line.to.x < line.from.x;
        const bool descends = isSteep ? line.to.y < line.from.y : isLeft;
        const LineStart start = m_bugs.start;
        const bool isSwapped = (start == LineStart::LeastAlong && descends)
            || (start == LineStart::LeastX && isLeft)
            || (start == LineStart::LeastXOfFlat && !isSteep && descends)
            || (start == LineStart::LeastYOfSteep && isSteep && descends);
        if (!isSwapped)
            return;
        std::swap(line.from, line.to);
        if (m_bugs.colours != LineColours::AsGiven)
            std::swap(line.fromColour, line.toColour);
    }
    /// Δx and Δy.
    std::pair<std::int64_t, std::int64_t> differencesOf(const LineEnds &ends) const
    {
        const std::int64_t along = std::abs(ends.toAlong - ends.fromAlong);
        const std::int64_t across = std::abs(ends.toAcross - ends.fromAcross);
        const bool areOwn = m_bugs.steep == SteepLine::OwnDifferences && ends.isSteep;
        return areOwn ? std::pair(across, along) : std::pair(along, across);
    }
    std::int64_t lastStep(std::int64_t length) const
    {
        const bool isShort = m_settings.variants.contains(Variant::OneStepShort) && length > 0;
        const bool isPast = m_bugs.last == LastStep::OnePast;
        return length + (isPast ? 1 : 0) - (isShort ? 1 : 0);
    }
    /// The line's offset across after each step, px.
    std::vector<std::int64_t> stepsAcross(const LineEnds &ends, std::int64_t last)
    {
        const std::int64_t rise = ends.toAcross - ends.fromAcross;
        const auto [dx, dy] = differencesOf(ends);
        const std::int64_t unit = stepOf(rise);
        const bool isCarried = m_bugs.decisionStart == DecisionStart::OfLineBefore;
        std::int64_t p = first(dx, dy);
        if (isCarried && m_hasDecision)
            p = m_decision;
        std::vector<std::int64_t> across = {0};
        for (std::int64_t step = 0; step <= last; ++step) {
            if (m_bugs.update == DecisionUpdate::BeforeTest)
                p += stay(dx, dy);
            const bool crosses = isPositive(p) == (m_bugs.steps == StepsAcross::WherePositive);
            across.push_back(across.back() + (crosses ? unit : 0));
            p = following(p, crosses, dx, dy);
        }
        m_decision = p;
        m_hasDecision = true;
        return across;
    }
    std::int64_t first(std::int64_t dx, std::int64_t dy) const
    {
        return valueOf(m_bugs.first, DecisionTerm::Midpoint, dx, dy);
    }
    std::int64_t stay(std::int64_t dx, std::int64_t dy) const
    {
        return valueOf(m_bugs.stay, DecisionTerm::TwiceRise, dx, dy);
    }
    std::int64_t cross(std::int64_t dx, std::int64_t dy) const
    {
        return valueOf(m_bugs.cross, DecisionTerm::TwiceDifference, dx, dy);
    }
    bool isPositive(std::int64_t p) const
    {
        return p > 0 || (p == 0 && !m_settings.variants.contains(Variant::StayAtZero));
    }
    std::int64_t following(std::int64_t p, bool crosses, std::int64_t dx, std::int64_t dy) const
    {
        const std::int64_t added = crosses ? cross(dx, dy) : stay(dx, dy);
        switch (m_bugs.update) {
        case DecisionUpdate::AfterTest:
            return p + added;
        case DecisionUpdate::AddsAlways:
            return p + added + (crosses ? stay(dx, dy) : 0);
        case DecisionUpdate::BeforeTest:
            return p + added - stay(dx, dy);
        case DecisionUpdate::SetBack:
            break;
        }
        return crosses ? first(dx, dy) : p + added;
    }
    std::int64_t stepOf(std::int64_t rise) const
    {
        switch (m_bugs.across) {
        case AcrossStep::TowardsEnd:
            return rise < 0 ? -1 : 1;
        case AcrossStep::Upward:
            return 1;
        case AcrossStep::Downward:
            return -1;
        case AcrossStep::AwayFromEnd:
            return rise < 0 ? 1 : -1;
        case AcrossStep::NoneDownward:
            break;
        }
        return rise < 0 ? 0 : 1;
    }
    Colour colourAt(const DrawnLine &line, std::int64_t step, std::int64_t length) const
    {
        Colour colour;
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = line.fromColour.channels[i];
            const auto rise = risen(line.toColour.channels[i] - from, step, length);
            const CommonFraction level{rise.numerator + from * rise.denominator, rise.denominator};
            const bool isNearest = m_settings.rounding == ByteRounding::Nearest;
            const Int128 whole = isNearest ? level.nearest() : level.floor();
            colour.channels[i] = std::uint8_t(std::clamp<Int128>(whole, 0, 255));
        }
        return colour;
    }
    /// What is added to the start's level.
    CommonFraction risen(int difference, std::int64_t step, std::int64_t length) const
    {
        if (length == 0)
            return {0, 1};
        const Int128 whole = Int128(difference) * step;
        switch (m_bugs.colours) {
        case LineColours::Right:
        case LineColours::AsGiven:
            break;
        case LineColours::DividedByOneMore:
            return {whole, length + 1};
        case LineColours::DividedByOneLess:
            return {whole, std::max<std::int64_t>(length - 1, 1)};
        case LineColours::WholeIncrements:
            return {Int128(difference / length) * step, 1};
        case LineColours::FlooredIncrements:
            return {floorDivide<Int128>(difference, length) * step, 1};
        case LineColours::OneAhead:
            return {whole + difference, length};
        case LineColours::OfStart:
            return {0, 1};
        }
        return {whole, length};
    }

    const LineBugs &m_bugs;
    const ScanSettings &m_settings;
    std::int64_t m_decision = 0; ///< the last line's
    bool m_hasDecision = false;
};

} // namespace

Picture drawnBy(const LineBugs &bugs, const Scene &scene)
{
    Picture picture = emptyPicture(scene.frame);
    LineSteps steps(bugs, scene);
    const std::vector<Shape> onSamples = primitivesOnSamples(scene).shapes;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Vertex &from = onSamples[i].vertices[0];
        const Vertex &to = onSamples[i].vertices[1];
        DrawnLine line{from.position, to.position, from.colour, to.colour};
        line.pixels = bugs.stepsItself() && line.isBetweenSamples()
            ? steps.pixelsOf(line)
            : pixelsOfMethod(shapeAlone(scene, i));
        changePixels(line, bugs,
                     scene.method == "line-slope-intercept" ? LineAxis::X
                                                            : lineAxisOf(line.from, line.to));
        for (const LinePixel &pixel : line.pixels) {
            const std::int64_t x = pixel.x - scene.frame.firstColumn;
            const bool isInside = x >= 0 && x < scene.frame.width && pixel.y >= scene.frame.firstRow
                && pixel.y - scene.frame.firstRow < scene.frame.height;
            if (!isInside)
                continue;
            const std::size_t place
                = picture.placeOf(int(x), int(pictureLine(scene.frame, pixel.y)));
            picture.colours[place] = pixel.colour;
            picture.covered[place] = 1;
        }
    }
    return picture;
}

} // namespace pixelplumb
