// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/programwalk.h"

#include "core/scan/variedscan.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Where an edge meets a span. Of coordinates up to 2^15 px the numerators stay below 2^48 and the
/// denominator, ΔX·S, below 2^33.
struct EdgePlace {
    Int128 denominator = 1; ///< > 0: of all
    Int128 along = 0; ///< px
    std::array<Int128, 3> levels = {};
};

/// An edge that is stepped from span to span.
class WalkedEdge {
public:
    WalkedEdge(const Vertex &from, const Vertex &to, const ProgramWalk &walk, VariantSet departures)
        : m_from(from)
        , m_to(to)
        , m_slopes(walk.slopes)
        , m_colours(walk.edgeColours)
        , m_width(to.position.x - from.position.x)
    {
        if (m_width == 0)
            return;
        if (departures.contains(Variant::DivisorMinusOne))
            m_width = std::max<Lattice>(m_width - unitsPerPixel, 0);
        if (departures.contains(Variant::DivisorPlusOne))
            m_width += unitsPerPixel;
        const Lattice late = ceilPixel(from.position.x) * unitsPerPixel - from.position.x;
        const bool isLate = departures.contains(Variant::NoEdgePreStep);
        m_lateAlong = isLate ? late : 0;
        m_lateColours = isLate || walk.edgeColourStart == EdgeColourStart::OfVertex ? late : 0;
    }

    /// One along the spans stays at its vertex.
    EdgePlace at(std::int64_t span) const
    {
        EdgePlace place;
        place.denominator = Int128(std::max<Lattice>(m_width, 1)) * unitsPerPixel;
        const Lattice way = span * unitsPerPixel - m_from.position.x;
        place.along = alongAt(m_width == 0 ? 0 : way - m_lateAlong);
        for (std::size_t i = 0; i < 3; ++i)
            place.levels[i] = levelAt(i, m_width == 0 ? 0 : way - m_lateColours);
        return place;
    }

private:
    Int128 alongAt(Int128 way) const
    {
        const Int128 rise = m_to.position.y - m_from.position.y;
        if (m_width == 0)
            return m_from.position.y;
        if (m_slopes == Quotient::Whole)
            return (m_from.position.y + way * (rise / m_width)) * m_width;
        return Int128(m_from.position.y) * m_width + way * rise;
    }
    Int128 levelAt(std::size_t channel, Int128 way) const
    {
        const Int128 level = m_from.colour.channels[channel];
        const Int128 rise = m_to.colour.channels[channel] - level;
        if (m_width == 0)
            return level * unitsPerPixel;
        if (m_colours == Quotient::Whole)
            return (level * unitsPerPixel + way * (rise * unitsPerPixel / m_width)) * m_width;
        return (level * m_width + way * rise) * unitsPerPixel;
    }

    const Vertex &m_from;
    const Vertex &m_to;
    Quotient m_slopes, m_colours;
    Lattice m_width; ///< by which is divided; 0: nothing is
    Lattice m_lateAlong = 0, m_lateColours = 0; ///< what is missing of the pre-step
};

int compareAlong(const EdgePlace &a, const EdgePlace &b)
{
    const Int128 difference = a.along * b.denominator - b.along * a.denominator;
    return difference < 0 ? -1 : int(difference > 0);
}

/// By rule: what belongs to the interval at this end.
std::int64_t firstOf(const EdgePlace &lower, EndRounding rounding, Interval interval)
{
    const Int128 floor = floorDivide(lower.along, lower.denominator);
    const Int128 ceil = ceilDivide(lower.along, lower.denominator);
    switch (rounding) {
    case EndRounding::ByRule:
        break;
    case EndRounding::Down:
        return std::int64_t(floor);
    case EndRounding::Nearest:
        return std::int64_t(
            floorDivide(2 * lower.along + lower.denominator, 2 * lower.denominator));
    case EndRounding::Up:
        return std::int64_t(ceil);
    }
    return std::int64_t(ownsFirst(interval) ? ceil : floor + 1);
}

std::int64_t endOf(const EdgePlace &upper, EndRounding rounding, Interval interval)
{
    if (rounding != EndRounding::ByRule)
        return firstOf(upper, rounding, interval) + 1;
    return std::int64_t(ownsLast(interval) ? floorDivide(upper.along, upper.denominator) + 1
                                           : ceilDivide(upper.along, upper.denominator));
}

/// Colours from sample to sample: ΔR = (R_T − R_B)/(y_T − y_B), R = R_B + (first − y_B)·ΔR.
/// |y_T − y_B| over both denominators stays below 2^80, and all numerators below 2^122.
class SpanColours {
public:
    SpanColours(const ProgramWalk &walk, bool hasPreStep)
        : m_walk(walk)
        , m_hasPreStep(hasPreStep && walk.divisor != SpanDivisor::WholeSteps)
    {
    }

    LevelRamp between(const EdgePlace &lower, const EdgePlace &upper, const SampleRun &run) const
    {
        const Int128 unit = lower.denominator * upper.denominator;
        Int128 height = upper.along * lower.denominator - lower.along * upper.denominator;
        if (m_walk.divisor == SpanDivisor::HeightAndOne)
            height += unit;
        if (m_walk.divisor == SpanDivisor::WholeSteps)
            height = (run.end - 1 - run.first) * unit;
        if (height == 0)
            return {lower.levels, {}, lower.denominator}; // nothing to share out
        const Int128 sign = height < 0 ? -1 : 1;
        height *= sign;
        LevelRamp ramp;
        ramp.denominator = lower.denominator * height;
        const Int128 way = m_hasPreStep ? run.first * lower.denominator - lower.along : 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Int128 rise = sign
                * (upper.levels[i] * lower.denominator - lower.levels[i] * upper.denominator);
            const Int128 whole = rise / height;
            const bool isWhole = m_walk.preSteps == Quotient::Whole;
            ramp.first[i] = lower.levels[i] * height + way * (isWhole ? whole * height : rise);
            ramp.rate[i] = m_walk.steps == Quotient::Whole ? whole * ramp.denominator
                                                           : rise * lower.denominator;
        }
        return ramp;
    }

private:
    const ProgramWalk &m_walk;
    bool m_hasPreStep;
};

/// The triangle as a program sees it that goes through spans in ascending order.
TriangleRuns seenFrom(const TriangleRuns &triangle, WalkOrder order)
{
    TriangleRuns seen = triangle;
    seen.runs.clear();
    if (order == WalkOrder::Ascending)
        return seen;
    for (Vertex &vertex : seen.triangle.vertices)
        vertex.position.x = -vertex.position.x;
    seen.firstSpan = 1 - triangle.endSpan;
    seen.endSpan = 1 - triangle.firstSpan;
    seen.intervals.columns = reversed(triangle.intervals.columns);
    return seen;
}

/// The triangle's spans from the first vertex to the last.
void walkUp(TriangleRuns &seen, const ProgramWalk &walk, VariantSet departures)
{
    const std::array<int, 3> order = sortedByColumn(seen.triangle);
    const Triangle triangle = departures.contains(Variant::UnsortedColours)
        ? withUnsortedColours(seen.triangle, order)
        : seen.triangle;
    const auto vertex = [&](std::size_t place) -> const Vertex & {
        return triangle.vertices[std::size_t(order[place])];
    };
    const Vertex &p0 = vertex(0);
    const Vertex &p1 = vertex(1);
    const Vertex &p2 = vertex(2);
    const WalkedEdge acrossAll(p0, p2, walk, departures);
    const WalkedEdge ofFirstHalf(p0, p1, walk, departures);
    const WalkedEdge ofSecondHalf(p1, p2, walk, departures);
    const bool isLongAbove = doubledArea(p0.position, p1.position, p2.position) >= 0;
    const std::int64_t end
        = std::min(endSampleAt(p2.position.x, seen.intervals.columns), seen.endSpan);
    const SpanColours colours(walk, !departures.contains(Variant::NoColourPreStep));
    for (std::int64_t span
         = std::max(firstSampleFrom(p0.position.x, seen.intervals.columns), seen.firstSpan);
         span < end; ++span) {
        const bool isFirstHalf = span < ceilPixel(p1.position.x);
        const EdgePlace across = acrossAll.at(span);
        const EdgePlace along = (isFirstHalf ? ofFirstHalf : ofSecondHalf).at(span);
        // As in the scan: bounds that have passed each other change places where both are owned.
        const int side = seen.intervals.rows == Interval::Closed ? compareAlong(across, along) : 0;
        const bool isAcrossUpper = side == 0 ? isLongAbove : side > 0;
        const EdgePlace &lower = isAcrossUpper ? along : across;
        const EdgePlace &upper = isAcrossUpper ? across : along;
        SampleRun run{span, firstOf(lower, walk.first, seen.intervals.rows),
                      endOf(upper, walk.last, seen.intervals.rows)};
        if (run.first >= run.end)
            continue;
        run.levels = colours.between(lower, upper, run);
        seen.runs.push_back(run);
    }
}

/// Who goes from the other end has no departures along edges from the method's own.
VariantSet departuresOf(const TriangleRuns &triangle, WalkOrder order)
{
    VariantSet departures = triangle.departures;
    for (const Variant variant : variantsAlongEdges) {
        if (order != triangle.order)
            departures = departures.without(variant);
    }
    return departures;
}

} // namespace

void walkAs(TriangleRuns &triangle, const ProgramWalk &walk)
{
    const bool isNarrowEnough = std::ranges::all_of(
        triangle.triangle.vertices, [](const Vertex &vertex) { return isNarrow(vertex.position); });
    if (doubledArea(triangle.triangle) == 0 || !isNarrowEnough)
        return;
    const WalkOrder order = walk.order.value_or(triangle.order);
    TriangleRuns seen = seenFrom(triangle, order);
    walkUp(seen, walk, {departuresOf(triangle, order).bits | walk.departures.bits});
    triangle.runs = std::move(seen.runs);
    if (order == WalkOrder::Ascending)
        return;
    for (SampleRun &run : triangle.runs)
        run.span = -run.span;
    std::ranges::reverse(triangle.runs);
}

std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk)
{
    return [walk](TriangleRuns &triangle) { walkAs(triangle, walk); };
}

} // namespace pixelplumb
