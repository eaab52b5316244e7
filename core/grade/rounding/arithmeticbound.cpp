// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/rounding/arithmeticbound.h"

#include "core/scan/errorlimit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>

namespace pixelplumb {

namespace {

constexpr ProgramWays columnWalk = 1;
constexpr ProgramWays rowWalk = 2;
constexpr ProgramWays roundedFunctions = 4;
constexpr ProgramWays firstThirdWeight = 8; // 54 ways

double pixels(Lattice coordinate) { return double(coordinate) / double(unitsPerPixel); }

/// The change of the vertices' values per pixel along one coordinate; `across`: the vertices' other
/// coordinate.
double slopeOf(const std::array<double, 3> &values, const std::array<double, 3> &across,
               double area)
{
    return ((values[1] - values[0]) * (across[2] - across[0])
            - (values[2] - values[0]) * (across[1] - across[0]))
        / area;
}

/// The largest power of two that divides all of these.
double commonUnit(std::initializer_list<Lattice> numbers)
{
    Lattice bits = 0;
    for (const Lattice number : numbers)
        bits |= std::abs(number);
    return bits == 0 ? std::ldexp(1.0, 62) : double(bits & -bits);
}

/// Calls visit(third) with 1 − α − β by quotients and by the reciprocal of the area, in each order.
/// The weights are Weights, what is computed of them Sums: 1.0 - a - b of floats is a double.
template <class Weight, class Sum, class Visit>
void visitThirdWeights(double alpha, double beta, double area, const Visit &visit)
{
    const Weight inverse = Weight(1) / Weight(area);
    for (const auto &[a, b] : {std::pair(Weight(alpha) / Weight(area), Weight(beta) / Weight(area)),
                               std::pair(Weight(alpha) * inverse, Weight(beta) * inverse)}) {
        for (const Sum third :
             {Sum(Sum(1) - a) - b, Sum(Sum(1) - b) - a, Sum(1) - Sum(Weight(a + b))})
            visit(third);
    }
}

} // namespace

ArithmeticBound::ArithmeticBound(const Triangle &triangle, Arithmetic arithmetic)
    : m_triangle(triangle)
    , m_exchanged(triangle)
    , m_unit(arithmetic == Arithmetic::Float32 ? std::ldexp(1.0, -24) : std::ldexp(1.0, -53))
{
    std::array<double, 3> x = {};
    std::array<double, 3> y = {};
    for (std::size_t i = 0; i < 3; ++i) {
        LatticePoint &exchanged = m_exchanged.vertices[i].position;
        std::swap(exchanged.x, exchanged.y);
        x[i] = pixels(triangle.vertices[i].position.x);
        y[i] = pixels(triangle.vertices[i].position.y);
    }
    const auto [left, right] = std::ranges::minmax(x);
    const auto [bottom, top] = std::ranges::minmax(y);
    const double largestX = std::max(std::abs(left), std::abs(right));
    const double largestY = std::max(std::abs(bottom), std::abs(top));
    m_extent = {right - left, top - bottom};
    m_largest = std::max({largestX, largestY, 1.0});
    const double area = double(doubledArea(triangle)) / double(unitsPerPixel * unitsPerPixel);
    m_area = std::abs(area);
    const double columns = std::ceil(m_extent[0]) + 2;
    const double rows = std::ceil(m_extent[1]) + 2;
    m_columnError = errorLimit(arithmetic, columns, largestY, m_extent[1]);
    m_rowError = errorLimit(arithmetic, rows, largestX, m_extent[0]);
    m_columnLevelError = errorLimit(arithmetic, columns, levels, levels);
    m_rowLevelError = errorLimit(arithmetic, rows, levels, levels);
    const double reached = m_largest + 1; // by the samples next to the triangle's box
    m_functionError = 33 * m_unit * reached * reached;
    m_isProved = m_largest <= largestProved && area != 0;
    if (!m_isProved)
        return;
    setWalkErrors();
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::array<double, 3> values = {};
        for (std::size_t i = 0; i < 3; ++i)
            values[i] = triangle.vertices[i].colour.channels[channel];
        m_gradient[channel] = {slopeOf(values, y, area), -slopeOf(values, x, area)};
    }
}

/// The vertices' x in a walk by columns, or y in one by rows.
std::array<Lattice, 3> ArithmeticBound::placesAlong(SpanAxis walk) const
{
    const auto &[a, b, c] = m_triangle.vertices;
    return walk == SpanAxis::Column ? std::array{a.position.x, b.position.x, c.position.x}
                                    : std::array{a.position.y, b.position.y, c.position.y};
}

/// Whether walking along an edge by its increments rounds nothing: the slope is a binary fraction,
/// and the number holds all multiples of the unit that sums consist of.
bool ArithmeticBound::isWalkedExactly(std::size_t edge, SpanAxis walk) const
{
    const bool byColumns = walk == SpanAxis::Column;
    const LatticePoint &from = m_triangle.vertices[edge].position;
    const LatticePoint &to = m_triangle.vertices[(edge + 1) % 3].position;
    const Lattice along = std::abs(byColumns ? to.x - from.x : to.y - from.y);
    const Lattice across = std::abs(byColumns ? to.y - from.y : to.x - from.x);
    if (along == 0)
        return true; // an integer bound, compared without rounding
    const Lattice divisor = std::gcd(along, across);
    if (!std::has_single_bit(std::uint64_t(along / divisor)))
        return false;
    const double step = byColumns ? commonUnit({from.x, to.x, unitsPerPixel})
                                  : commonUnit({from.y, to.y, unitsPerPixel});
    const double start = byColumns ? commonUnit({from.y, to.y}) : commonUnit({from.x, to.x});
    const double unit = std::min(start, step * double(divisor) / double(along));
    return double(across / divisor) * m_unit <= 1
        && (m_largest + 1) * double(unitsPerPixel) / unit * m_unit <= 1;
}

/// Whether all products and sums of the three edge functions are multiples that the number holds.
bool ArithmeticBound::areFunctionsExact() const
{
    const auto &[a, b, c] = m_triangle.vertices;
    const double unit = commonUnit({a.position.x, b.position.x, c.position.x, unitsPerPixel})
        * commonUnit({a.position.y, b.position.y, c.position.y, unitsPerPixel});
    const double reached = (m_largest + 1) * double(unitsPerPixel);
    return 8 * reached * reached / unit * m_unit <= 1;
}

void ArithmeticBound::setWalkErrors()
{
    m_hasExactFunctions = areFunctionsExact();
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const LatticePoint &from = m_triangle.vertices[edge].position;
        const LatticePoint &to = m_triangle.vertices[(edge + 1) % 3].position;
        if (!isWalkedExactly(edge, SpanAxis::Column))
            m_walkErrors[0][edge] = pixels(std::abs(to.x - from.x)) * m_columnError;
        if (!isWalkedExactly(edge, SpanAxis::Row))
            m_walkErrors[1][edge] = pixels(std::abs(to.y - from.y)) * m_rowError;
    }
}

ArithmeticBound::Sample ArithmeticBound::sampleAt(std::int64_t x, std::int64_t y,
                                                  const std::optional<BoundaryRule> &rule) const
{
    const oracle::SampleVerdict verdict
        = oracle::judge(m_triangle, rule.value_or(FillRule::Closed), x, y);
    Sample sample;
    for (std::size_t i = 0; i < 3; ++i) {
        sample.functions[i]
            = double(verdict.edges[i].edgeFunction) / double(unitsPerPixel * unitsPerPixel);
        sample.areOwned[i] = verdict.edges[i].accepts;
    }
    return sample;
}

Containment ArithmeticBound::containmentWithin(const Sample &sample,
                                               const std::array<double, 3> &errors,
                                               const std::optional<BoundaryRule> &rule)
{
    Containment found = Containment::Inside;
    for (std::size_t i = 0; i < 3; ++i) {
        if (sample.functions[i] < -errors[i])
            return Containment::Outside;
        if (sample.functions[i] > errors[i])
            continue;
        const bool isDecided = rule && errors[i] == 0;
        if (isDecided && !sample.areOwned[i])
            return Containment::Outside;
        if (!isDecided)
            found = Containment::Undecided;
    }
    return found;
}

ProgramWays ArithmeticBound::deviatingThirdWeights(const Sample &sample,
                                                   const std::optional<BoundaryRule> &rule) const
{
    ProgramWays deviating = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double function = sample.functions[i];
        const std::size_t next = (i + 1) % 3;
        const std::size_t last = (i + 2) % 3;
        const auto isRefused = [&](std::size_t edge) {
            return sample.functions[edge] < 0
                || (sample.functions[edge] == 0 && !sample.areOwned[edge]);
        };
        // What the other two refuse is refused whatever the third weight.
        if (std::abs(function) > 8 * m_unit * m_area
            || (rule && (isRefused(next) || isRefused(last))))
            continue;
        ProgramWays way = firstThirdWeight << (i * 18);
        const auto compare = [&](auto third) {
            const bool isOther = rule
                ? (third < 0 || (third == 0 && !sample.areOwned[i])) != isRefused(i)
                : (third > 0) != (function > 0) || (third < 0) != (function < 0);
            deviating |= isOther ? way : 0;
            way <<= 1;
        };
        visitThirdWeights<double, double>(sample.functions[next], sample.functions[last], m_area,
                                          compare);
        if (m_unit == std::ldexp(1.0, -53))
            continue;
        visitThirdWeights<float, float>(sample.functions[next], sample.functions[last], m_area,
                                        compare);
        visitThirdWeights<float, double>(sample.functions[next], sample.functions[last], m_area,
                                         compare);
    }
    return deviating;
}

Containment ArithmeticBound::byFunctions(const Sample &sample,
                                         const std::optional<BoundaryRule> &rule) const
{
    if (m_hasExactFunctions)
        return deviatingThirdWeights(sample, rule) == 0 ? containmentWithin(sample, {}, rule)
                                                        : Containment::Undecided;
    if (m_area <= 2 * m_functionError)
        return Containment::Undecided;
    const double error = 2 * m_functionError + 4 * m_unit * m_area; // of the third weight, too
    return containmentWithin(sample, {error, error, error}, rule);
}

SampleBox ArithmeticBound::reachIn(const FrameSpec &frame) const
{
    // Errors extend beyond the box; those of edge functions by one sample.
    const SampleBox box = boundingBoxOf(m_triangle);
    const auto rows = std::int64_t(std::min(m_columnError, largestProved)) + 1;
    const auto columns = std::int64_t(std::min(m_rowError, largestProved)) + 1;
    return intersection(
        {box.firstX - columns, box.endX + columns, box.firstY - rows, box.endY + rows},
        samplesOf(windowOf(frame)));
}

double ArithmeticBound::endError(SpanAxis axis) const
{
    if (m_largest > largestProved)
        return std::numeric_limits<double>::infinity();
    return axis == SpanAxis::Column ? m_columnError : m_rowError;
}

/// By a walk, whose bound in the column or row of a middle vertex may come from either of the edges
/// that meet there: the error of one adds up to where it ends, the other begins there without any.
Containment ArithmeticBound::byWalk(const Sample &sample, SpanAxis walk, std::int64_t at,
                                    const std::optional<BoundaryRule> &rule) const
{
    const std::array<double, 3> &errors = m_walkErrors[walk == SpanAxis::Column ? 0 : 1];
    const auto places = placesAlong(walk);
    const auto [first, last] = std::ranges::minmax(places);
    std::optional<std::size_t> middle;
    for (std::size_t i = 0; i < 3; ++i) {
        if (places[i] == at * unitsPerPixel && places[i] != first && places[i] != last)
            middle = i;
    }
    if (!middle)
        return containmentWithin(sample, errors, rule);
    // Edge i goes from vertex i to the next. One of the two is not asked: it is far on the inside.
    std::array<Containment, 2> found = {};
    for (std::size_t i = 0; i < 2; ++i) {
        Sample asked = sample;
        asked.functions[(*middle + 2 * i) % 3] = std::numeric_limits<double>::max();
        found[i] = containmentWithin(asked, errors, rule);
    }
    return found[0] == found[1] ? found[0] : Containment::Undecided;
}

ProgramWays ArithmeticBound::deviatingWays(const Sample &sample, std::int64_t x, std::int64_t y,
                                           const std::optional<BoundaryRule> &rule) const
{
    const Containment exact = containmentWithin(sample, {}, rule);
    ProgramWays deviating = 0;
    if (byWalk(sample, SpanAxis::Column, x, rule) != exact)
        deviating |= columnWalk;
    if (byWalk(sample, SpanAxis::Row, y, rule) != exact)
        deviating |= rowWalk;
    if (m_hasExactFunctions)
        deviating |= deviatingThirdWeights(sample, rule);
    else if (byFunctions(sample, rule) != exact)
        deviating |= roundedFunctions;
    return deviating;
}

Containment ArithmeticBound::containmentOf(std::int64_t x, std::int64_t y,
                                           const std::optional<BoundaryRule> &rule,
                                           ProgramWays ways) const
{
    if (!m_isProved)
        return Containment::Undecided;
    const Sample sample = sampleAt(x, y, rule);
    return (deviatingWays(sample, x, y, rule) & ways) != 0 ? Containment::Undecided
                                                           : containmentWithin(sample, {}, rule);
}

} // namespace pixelplumb
