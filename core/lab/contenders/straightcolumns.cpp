// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/levelplane.h"
#include "core/lab/contenders/straightedge.h"
#include "core/number/fixedpoint.h"

/// The assignment's column scan, and the row walk as its turned twin.
namespace pixelplumb {

namespace {

template <class Fixed>
struct Binary {
    using Number = Fixed;
    static Fixed of(Lattice units) { return Fixed::fromBinaryFraction(units, unitsPerPixel); }
    static Fixed whole(std::int64_t integer) { return Fixed::fromInteger(integer); }
    static std::int64_t floor(Fixed v) { return v.floor(); }
    static std::int64_t ceil(Fixed v) { return v.ceil(); }
    static QRgb pixel(const std::array<Fixed, 3> &level)
    {
        const auto nearest
            = [](Fixed value) { return (value + Fixed::fromBinaryFraction(1, 2)).floor(); };
        return pixelOfLevels({nearest(level[0]), nearest(level[1]), nearest(level[2])});
    }
};

/// Quotients and remainders in 64 bits, true by proof: edges by increments, colours by the plane's
/// increments.
template <StraightRule rule>
void drawExact(const Triangle &triangle, RawFrame frame)
{
    const Vertex &p0 = triangle.vertices[0];
    const LevelPlane<std::int64_t> plane(p0, triangle.vertices[1], triangle.vertices[2]);
    const std::int64_t area = plane.area;
    StraightQuotient rate[3];
    for (std::size_t i = 0; i < 3; ++i)
        rate[i] = StraightQuotient(plane.perY[i] * unitsPerPixel, area);
    walkTriangleEdges<rule, QuotientEdge>(
        triangle,
        [&](std::int64_t x, std::int64_t first, std::int64_t end, const QuotientEdge &,
            const QuotientEdge &) {
            const std::int64_t along = x * unitsPerPixel - p0.position.x;
            const std::int64_t up = first * unitsPerPixel - p0.position.y;
            StraightQuotient level[3];
            for (std::size_t i = 0; i < 3; ++i)
                level[i] = StraightQuotient(plane.numerator(p0, i, along, up), area);
            QRgb *pixel = frame.at(x, first);
            for (std::int64_t y = first; y < end; ++y, pixel += frame.perV) {
                const auto nearest = [&](const StraightQuotient &each) {
                    return each.whole + std::int64_t(each.remainder >= area - each.remainder);
                };
                *pixel = pixelOfLevels({nearest(level[0]), nearest(level[1]), nearest(level[2])});
                for (std::size_t i = 0; i < 3; ++i)
                    level[i].add(rate[i], area);
            }
        });
}

/// float64, true by proof: multiplying instead of adding up, with half a quantum of bias.
struct BiasEdge {
    static constexpr bool mayCross = false;
    double y, run, slope = 0, bias;

    BiasEdge(const Vertex &from, const Vertex &to, std::int64_t column)
        : y(straightPixels<double>(from.position.y))
        , run(straightPixels<double>(column * unitsPerPixel - from.position.x))
    {
        const LatticePoint &a = from.position, &b = to.position;
        const auto width = double(b.x - a.x);
        if (width != 0)
            slope = double(b.y - a.y) / width;
        bias = 0.5 / ((width == 0 ? 1 : width) * unitsPerPixel);
    }
    std::int64_t ceil() const { return Real<double>::ceil(y + run * slope - bias); }
    std::int64_t floor() const { return Real<double>::floor(y + run * slope + bias); }
    void step() { run += 1; }
};

template <StraightRule rule>
void drawBias(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const LevelPlane<std::int64_t> plane(p0, triangle.vertices[std::size_t(i1)],
                                         triangle.vertices[std::size_t(i2)]);
    const auto area = double(plane.area);
    double from[3], perX[3], perY[3];
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = double(p0.colour.channels[i]);
        perX[i] = double(plane.perX[i] * unitsPerPixel) / area;
        perY[i] = double(plane.perY[i] * unitsPerPixel) / area;
    }
    const double half = 0.5 + 0.25 / area;
    walkTriangleEdges<rule, BiasEdge>(
        triangle,
        [&](std::int64_t x, std::int64_t first, std::int64_t end, const BiasEdge &,
            const BiasEdge &) {
            const auto along = straightPixels<double>(x * unitsPerPixel - p0.position.x);
            auto up = straightPixels<double>(first * unitsPerPixel - p0.position.y);
            double base[3];
            for (std::size_t i = 0; i < 3; ++i)
                base[i] = from[i] + perX[i] * along;
            QRgb *pixel = frame.at(x, first);
            for (std::int64_t y = first; y < end; ++y, up += 1, pixel += frame.perV) {
                const auto byte = [&](std::size_t i) {
                    const double level = base[i] + up * perY[i] + half;
                    return int(level < 0 ? 0 : level > 255 ? 255 : level);
                };
                *pixel = qRgb(byte(0), byte(1), byte(2));
            }
        });
}

template <class N>
constexpr StraightLoop roundedRow(const char *method, Arithmetic arithmetic, SpanAxis axis)
{
    return {method, arithmetic, axis, drawBetweenEdges<N, RoundedEdge<N, 3>, StraightRule::Closed>,
            drawBetweenEdges<N, RoundedEdge<N, 3>, StraightRule::HalfOpen>};
}

constexpr StraightLoop exactRow(const char *method, SpanAxis axis)
{
    return {method, Arithmetic::Exact, axis, drawExact<StraightRule::Closed>,
            drawExact<StraightRule::HalfOpen>};
}

constexpr StraightLoop rows[] = {
    roundedRow<Real<float>>("column-scan", Arithmetic::Float32, SpanAxis::Column),
    roundedRow<Real<double>>("column-scan", Arithmetic::Float64, SpanAxis::Column),
    roundedRow<Binary<FixedPoint16>>("column-scan", Arithmetic::Fixed16, SpanAxis::Column),
    roundedRow<Binary<FixedPoint32>>("column-scan", Arithmetic::Fixed32, SpanAxis::Column),
    roundedRow<Real<float>>("row-walk", Arithmetic::Float32, SpanAxis::Row),
    roundedRow<Real<double>>("row-walk", Arithmetic::Float64, SpanAxis::Row),
    roundedRow<Binary<FixedPoint16>>("row-walk", Arithmetic::Fixed16, SpanAxis::Row),
    roundedRow<Binary<FixedPoint32>>("row-walk", Arithmetic::Fixed32, SpanAxis::Row),
    exactRow("column-scan", SpanAxis::Column),
    {"column-scan-bias", Arithmetic::Float64, SpanAxis::Column, drawBias<StraightRule::Closed>,
     drawBias<StraightRule::HalfOpen>},
    exactRow("row-walk", SpanAxis::Row),
};

} // namespace

std::span<const StraightLoop> straightColumns() { return rows; }

} // namespace pixelplumb
