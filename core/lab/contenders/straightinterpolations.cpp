// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/levelplane.h"
#include "core/lab/contenders/straightedge.h"

/// The three forms of interpolation, for R G B only: coverage by quotients and remainders, channels
/// in floating point or in 64-bit fractions. The bilinear form has no exact loop: its quotients
/// along two edges take 128 bits, and only the plane would avoid them.
namespace pixelplumb {

namespace {

/// A number at the corners of a triangle, or of a plane's a·x + b·y + c.
template <class Number>
using Three = std::array<Number, 3>;

/// a·x + b·y + c of each channel, or of each weight.
template <class Number>
struct Forms {
    Three<Three<Number>> form;

    Three<Number> at(std::int64_t x, std::int64_t y) const
    {
        const auto value = [&](const Three<Number> &each) {
            return each[0] * Number(x) + each[1] * Number(y) + each[2];
        };
        return {value(form[0]), value(form[1]), value(form[2])};
    }
};

/// A sum of the vertices' levels, with their weights.
template <class Number>
struct Levels {
    Three<Three<Number>> level; ///< [vertex][channel]

    explicit Levels(const Triangle &triangle)
    {
        for (std::size_t v = 0; v < 3; ++v) {
            for (std::size_t i = 0; i < 3; ++i)
                level[v][i] = Number(triangle.vertices[v].colour.channels[i]);
        }
    }
    Three<Number> sums(const Three<Number> &weight) const
    {
        const auto sum = [&](std::size_t i) {
            return weight[0] * level[0][i] + weight[1] * level[1][i] + weight[2] * level[2][i];
        };
        return {sum(0), sum(1), sum(2)};
    }
};

template <std::floating_point Float>
struct FloatPlanes {
    Forms<Float> planes;

    explicit FloatPlanes(const Triangle &triangle)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            Three<Three<Float>> p;
            for (std::size_t v = 0; v < 3; ++v) {
                const Vertex &vertex = triangle.vertices[v];
                p[v] = {straightPixels<Float>(vertex.position.x),
                        straightPixels<Float>(vertex.position.y), Float(vertex.colour.channels[i])};
            }
            const auto cross = [&](std::size_t j, std::size_t k) {
                return (p[1][j] - p[0][j]) * (p[2][k] - p[0][k])
                    - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
            };
            const Float a = cross(1, 2), b = cross(2, 0), c = cross(0, 1);
            const Float d = -(a * p[0][0] + b * p[0][1] + c * p[0][2]);
            planes.form[i] = {-a / c, -b / c, -d / c};
        }
    }
    QRgb pixel(std::int64_t x, std::int64_t y) const { return Real<Float>::pixel(planes.at(x, y)); }
};

template <std::floating_point Float>
struct FloatWeights {
    Forms<Float> weights;
    Levels<Float> levels;

    explicit FloatWeights(const Triangle &triangle)
        : levels(triangle)
    {
        for (std::size_t v = 0; v < 3; ++v) {
            const auto x = [&](std::size_t i) {
                return straightPixels<Float>(triangle.vertices[(v + i) % 3].position.x);
            };
            const auto y = [&](std::size_t i) {
                return straightPixels<Float>(triangle.vertices[(v + i) % 3].position.y);
            };
            const Float a = y(2) - y(1);
            const Float b = x(1) - x(2);
            const Float c = -a * x(1) - b * y(1);
            const Float k = Float(1) / (a * x(0) + b * y(0) + c);
            weights.form[v] = {k * a, k * b, k * c};
        }
    }
    QRgb pixel(std::int64_t x, std::int64_t y) const
    {
        return Real<Float>::pixel(levels.sums(weights.at(x, y)));
    }
};

struct ExactPlanes {
    Forms<std::int64_t> planes;
    std::int64_t area;

    explicit ExactPlanes(const Triangle &triangle)
    {
        const auto &[p, q, r] = triangle.vertices;
        const LevelPlane<std::int64_t> plane(p, q, r);
        area = plane.area;
        for (std::size_t i = 0; i < 3; ++i)
            planes.form[i] = {plane.perX[i] * unitsPerPixel, plane.perY[i] * unitsPerPixel,
                              plane.numerator(p, i, -p.position.x, -p.position.y)};
    }
    QRgb pixel(std::int64_t x, std::int64_t y) const
    {
        return straightPixelOf(planes.at(x, y), area);
    }
};

struct ExactWeights {
    Forms<std::int64_t> weights;
    Levels<std::int64_t> levels;
    std::int64_t area;

    explicit ExactWeights(const Triangle &triangle)
        : levels(triangle)
        , area(std::int64_t(doubledArea(triangle)))
    {
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        for (std::size_t v = 0; v < 3; ++v) {
            const LatticePoint &p = triangle.vertices[(v + 1) % 3].position;
            const LatticePoint &q = triangle.vertices[(v + 2) % 3].position;
            const std::int64_t a = sign * (p.y - q.y), b = sign * (q.x - p.x);
            weights.form[v] = {a * unitsPerPixel, b * unitsPerPixel, -a * p.x - b * p.y};
        }
    }
    QRgb pixel(std::int64_t x, std::int64_t y) const
    {
        return straightPixelOf(levels.sums(weights.at(x, y)), area);
    }
};

/// Each sample is coloured by itself.
template <class Colours, StraightRule rule>
void drawEachSample(const Triangle &triangle, RawFrame frame)
{
    const Colours colours(triangle);
    walkTriangleEdges<rule, QuotientEdge>(triangle,
                                          [&](std::int64_t x, std::int64_t first, std::int64_t end,
                                              const QuotientEdge &, const QuotientEdge &) {
                                              QRgb *pixel = frame.at(x, first);
                                              for (std::int64_t y = first; y < end;
                                                   ++y, pixel += frame.perV)
                                                  *pixel = colours.pixel(x, y);
                                          });
}

/// Coverage is exact, the levels along the edge are not.
template <class N>
struct BilinearEdge : QuotientEdge {
    BilinearEdge(const Vertex &a, const Vertex &b, std::int64_t column)
        : QuotientEdge(a, b, column)
        , m_values(a, b, column)
    {
    }
    const RoundedEdge<N, 3> &values() const { return m_values; }
    void step()
    {
        QuotientEdge::step();
        m_values.step();
    }

private:
    RoundedEdge<N, 3> m_values;
};

using enum StraightRule;

template <class N>
constexpr StraightLoop bilinearRow(Arithmetic arithmetic)
{
    return {"interpolate-bilinear", arithmetic, SpanAxis::Column,
            drawBetweenEdges<N, BilinearEdge<N>, Closed>,
            drawBetweenEdges<N, BilinearEdge<N>, HalfOpen>};
}

template <class Colours>
constexpr StraightLoop row(const char *method, Arithmetic arithmetic)
{
    return {method, arithmetic, SpanAxis::Column, drawEachSample<Colours, Closed>,
            drawEachSample<Colours, HalfOpen>};
}

constexpr StraightLoop rows[] = {
    bilinearRow<Real<float>>(Arithmetic::Float32),
    bilinearRow<Real<double>>(Arithmetic::Float64),
    row<FloatPlanes<float>>("interpolate-plane", Arithmetic::Float32),
    row<FloatPlanes<double>>("interpolate-plane", Arithmetic::Float64),
    row<FloatWeights<float>>("interpolate-barycentric", Arithmetic::Float32),
    row<FloatWeights<double>>("interpolate-barycentric", Arithmetic::Float64),
    row<ExactPlanes>("interpolate-plane", Arithmetic::Exact),
    row<ExactWeights>("interpolate-barycentric", Arithmetic::Exact),
};

} // namespace

std::span<const StraightLoop> straightInterpolations() { return rows; }

} // namespace pixelplumb
