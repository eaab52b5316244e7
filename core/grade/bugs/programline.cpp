// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/programline.h"

#include "core/number/commonfraction.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// A line's coordinates along and across its steps, px.
struct LineEnds {
    std::int64_t fromAlong = 0, fromAcross = 0, toAlong = 0, toAcross = 0;
    bool isSteep = false; ///< x and y are exchanged
};

/// Draws lines one after another, each by its steps.
class LineSteps {
public:
    LineSteps(const ProgramLine &program, const Scene &scene)
        : m_program(program)
        , m_settings(scene.settings)
    {
    }

    void redraw(DrawnLine &line)
    {
        if (!isOnSample(line.from) || !isOnSample(line.to))
            return;
        const bool isSteep = isExchanged(line);
        sortEnds(line, isSteep);
        const LineEnds ends = endsOf(line, isSteep);
        line.pixels.clear();
        const bool descends = ends.toAlong < ends.fromAlong;
        if (descends && m_program.descending == DescendingLine::Lost)
            return;
        const bool isPixel = descends && m_program.descending == DescendingLine::FirstPixelAlone;
        const std::int64_t length = differencesOf(ends).first;
        const std::int64_t last = isPixel ? 0 : lastStep(length);
        const bool goesUp = !descends || m_program.descending == DescendingLine::Ascends;
        const std::vector<std::int64_t> across = stepsAcross(ends, last);
        for (std::int64_t step = 0; step <= last; ++step) {
            const std::int64_t x = ends.fromAlong + (goesUp ? step : -step);
            const std::int64_t y = ends.fromAcross + across[std::size_t(step)];
            line.pixels.push_back({isSteep ? y : x, isSteep ? x : y, colourAt(line, step, length)});
        }
    }

private:
    static bool isOnSample(const LatticePoint &point)
    {
        return point == latticePixel(floorPixel(point.x), floorPixel(point.y));
    }
    bool isExchanged(const DrawnLine &line) const
    {
        switch (m_program.steep) {
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
        const LineStart start = m_program.start;
        const bool isSwapped = (start == LineStart::LeastAlong && descends)
            || (start == LineStart::LeastX && isLeft)
            || (start == LineStart::LeastXOfFlat && !isSteep && descends)
            || (start == LineStart::LeastYOfSteep && isSteep && descends);
        if (!isSwapped)
            return;
        std::swap(line.from, line.to);
        if (m_program.colours != LineColours::AsGiven)
            std::swap(line.fromColour, line.toColour);
    }
    /// Δx and Δy.
    std::pair<std::int64_t, std::int64_t> differencesOf(const LineEnds &ends) const
    {
        const std::int64_t along = std::abs(ends.toAlong - ends.fromAlong);
        const std::int64_t across = std::abs(ends.toAcross - ends.fromAcross);
        const bool areOwn = m_program.steep == SteepLine::OwnDifferences && ends.isSteep;
        return areOwn ? std::pair(across, along) : std::pair(along, across);
    }
    std::int64_t lastStep(std::int64_t length) const
    {
        const bool isShort = m_settings.variants.contains(Variant::OneStepShort) && length > 0;
        const bool isPast = m_program.last == LastStep::OnePast;
        return length + (isPast ? 1 : 0) - (isShort ? 1 : 0);
    }
    /// The line's offset across after each step, px.
    std::vector<std::int64_t> stepsAcross(const LineEnds &ends, std::int64_t last)
    {
        const LineDecision &by = m_program.decision;
        const std::int64_t rise = ends.toAcross - ends.fromAcross;
        const auto [dx, dy] = differencesOf(ends);
        const std::int64_t unit = stepOf(rise);
        const bool isCarried = by.start == DecisionStart::OfLineBefore && m_decision;
        std::int64_t p = isCarried ? *m_decision : by.first(dx, dy);
        std::vector<std::int64_t> across = {0};
        for (std::int64_t step = 0; step <= last; ++step) {
            if (by.update == DecisionUpdate::BeforeTest)
                p += by.stay(dx, dy);
            const bool crosses = isPositive(p) == (by.steps == StepsAcross::WherePositive);
            across.push_back(across.back() + (crosses ? unit : 0));
            p = following(p, crosses, dx, dy);
        }
        m_decision = p;
        return across;
    }
    bool isPositive(std::int64_t p) const
    {
        return p > 0 || (p == 0 && !m_settings.variants.contains(Variant::StayAtZero));
    }
    std::int64_t following(std::int64_t p, bool crosses, std::int64_t dx, std::int64_t dy) const
    {
        const LineDecision &by = m_program.decision;
        const std::int64_t added = crosses ? by.cross(dx, dy) : by.stay(dx, dy);
        switch (by.update) {
        case DecisionUpdate::AfterTest:
            return p + added;
        case DecisionUpdate::AddsAlways:
            return p + added + (crosses ? by.stay(dx, dy) : 0);
        case DecisionUpdate::BeforeTest:
            return p + added - by.stay(dx, dy);
        case DecisionUpdate::SetBack:
            break;
        }
        return crosses ? by.first(dx, dy) : p + added;
    }
    std::int64_t stepOf(std::int64_t rise) const
    {
        switch (m_program.across) {
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
        switch (m_program.colours) {
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

    const ProgramLine &m_program;
    const ScanSettings &m_settings;
    std::optional<std::int64_t> m_decision; ///< the last line's
};

} // namespace

Picture drawnBy(const ProgramLine &program, const Scene &scene)
{
    LineSteps steps(program, scene);
    return redrawnLines(scene, [&steps](DrawnLine &line) { steps.redraw(line); });
}

} // namespace pixelplumb
