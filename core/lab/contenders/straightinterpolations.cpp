// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightedge.h"
#include "core/lab/contenders/straightloop.h"
#include "core/scan/interpolation/interpolationnumbers.h"

#include <algorithm>
#include <array>

/// The three forms of interpolation, for R G B only: coverage by quotients and remainders, channels
/// in floating point.
namespace pixelplumb {

namespace {

using Form = InterpolationForm;

template <class Float>
Float pixels(Lattice units)
{
    return Float(units) / Float(unitsPerPixel);
}

/// y and R G B along an edge by adding rates.
template <class Float>
struct ChannelRow {
    Float value[4], rate[4] = {};

    ChannelRow(const Vertex &a, const Vertex &b, std::int64_t column)
    {
        const auto of = [](const Vertex &vertex, std::size_t i) {
            return i == 3 ? pixels<Float>(vertex.position.y) : Float(vertex.colour.channels[i]);
        };
        const Float run = Float(column) - pixels<Float>(a.position.x);
        for (std::size_t i = 0; i < 4; ++i) {
            if (a.position.x != b.position.x) {
                rate[i] = (of(b, i) - of(a, i))
                    / (pixels<Float>(b.position.x) - pixels<Float>(a.position.x));
            }
            value[i] = of(a, i) + run * rate[i];
        }
    }
    void step()
    {
        for (std::size_t i = 0; i < 4; ++i)
            value[i] = value[i] + rate[i];
    }
};

/// a·x + b·y + c of each channel, or of each weight.
template <class Float>
using Forms = std::array<std::array<Float, 3>, 3>;

template <class Float>
Forms<Float> planesOf(const Triangle &triangle)
{
    Forms<Float> forms;
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<std::array<Float, 3>, 3> p;
        for (std::size_t v = 0; v < 3; ++v) {
            const Vertex &vertex = triangle.vertices[v];
            p[v] = {pixels<Float>(vertex.position.x), pixels<Float>(vertex.position.y),
                    Float(vertex.colour.channels[i])};
        }
        const auto cross = [&](std::size_t j, std::size_t k) {
            return (p[1][j] - p[0][j]) * (p[2][k] - p[0][k])
                - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
        };
        const Float a = cross(1, 2), b = cross(2, 0), c = cross(0, 1);
        const Float d = -(a * p[0][0] + b * p[0][1] + c * p[0][2]);
        forms[i] = {-a / c, -b / c, -d / c};
    }
    return forms;
}

template <class Float>
Forms<Float> weightsOf(const Triangle &triangle)
{
    Forms<Float> forms;
    for (std::size_t v = 0; v < 3; ++v) {
        const auto x = [&](std::size_t i) {
            return pixels<Float>(triangle.vertices[(v + i) % 3].position.x);
        };
        const auto y = [&](std::size_t i) {
            return pixels<Float>(triangle.vertices[(v + i) % 3].position.y);
        };
        const Float a = y(2) - y(1);
        const Float b = x(1) - x(2);
        const Float c = -a * x(1) - b * y(1);
        const Float k = Float(1) / (a * x(0) + b * y(0) + c);
        forms[v] = {k * a, k * b, k * c};
    }
    return forms;
}

template <class Float, Form form, StraightRule rule>
void drawInterpolated(const Triangle &triangle, RawFrame frame)
{
    const auto [i0, i1, i2] = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(i0)];
    const Vertex &p1 = triangle.vertices[std::size_t(i1)];
    const Vertex &p2 = triangle.vertices[std::size_t(i2)];
    const bool longAbove = doubledArea(p0.position, p1.position, p2.position) >= 0;
    Forms<Float> forms = {};
    if (form == Form::Plane)
        forms = planesOf<Float>(triangle);
    else if (form == Form::Barycentric)
        forms = weightsOf<Float>(triangle);
    Float level[3][3]; // [vertex][channel]
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t i = 0; i < 3; ++i)
            level[v][i] = Float(triangle.vertices[v].colour.channels[i]);
    }
    const auto at = [&](std::size_t i, std::int64_t x, std::int64_t y) {
        return forms[i][0] * Float(x) + forms[i][1] * Float(y) + forms[i][2];
    };
    const std::int64_t begin = ceilPixel(p0.position.x);
    const std::int64_t middle = ceilPixel(p1.position.x);
    const std::int64_t endColumn = straightEnd(rule, p2.position.x);
    StraightEdge longEdge(p0, p2, begin);
    ChannelRow<Float> longRow(p0, p2, begin);
    const auto walk = [&](StraightEdge shortEdge, ChannelRow<Float> shortRow, std::int64_t first,
                          std::int64_t end) {
        for (std::int64_t x = first; x < end; ++x) {
            const std::int64_t low = (longAbove ? shortEdge : longEdge).ceil();
            const StraightEdge &topEdge = longAbove ? longEdge : shortEdge;
            const std::int64_t endRow
                = rule == StraightRule::Closed ? topEdge.whole + 1 : topEdge.ceil();
            Float value[3] = {}, rate[3] = {};
            if constexpr (form == Form::Bilinear) {
                const ChannelRow<Float> &bottom = longAbove ? shortRow : longRow;
                const ChannelRow<Float> &top = longAbove ? longRow : shortRow;
                const Float height = top.value[3] - bottom.value[3];
                for (std::size_t i = 0; i < 3; ++i) {
                    rate[i]
                        = height == Float(0) ? Float(0) : (top.value[i] - bottom.value[i]) / height;
                    value[i] = bottom.value[i] + (Float(low) - bottom.value[3]) * rate[i];
                }
                shortRow.step();
                longRow.step();
            }
            QRgb *pixel = frame.at(x, low);
            for (std::int64_t y = low; y < endRow; ++y, pixel += frame.perV) {
                if constexpr (form == Form::Plane) {
                    for (std::size_t i = 0; i < 3; ++i)
                        value[i] = at(i, x, y);
                } else if constexpr (form == Form::Barycentric) {
                    const Float w[3] = {at(0, x, y), at(1, x, y), at(2, x, y)};
                    for (std::size_t i = 0; i < 3; ++i)
                        value[i] = w[0] * level[0][i] + w[1] * level[1][i] + w[2] * level[2][i];
                }
                *pixel = qRgb(byteOf(value[0]), byteOf(value[1]), byteOf(value[2]));
                if constexpr (form == Form::Bilinear) {
                    for (std::size_t i = 0; i < 3; ++i)
                        value[i] = value[i] + rate[i];
                }
            }
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(StraightEdge(p0, p1, begin), ChannelRow<Float>(p0, p1, begin), begin, middle);
    walk(StraightEdge(p1, p2, middle), ChannelRow<Float>(p1, p2, middle), middle, endColumn);
}

using enum StraightRule;

constexpr StraightLoop rows[] = {
    {"interpolate-bilinear", Arithmetic::Float32, SpanAxis::Column,
     drawInterpolated<float, Form::Bilinear, Closed>,
     drawInterpolated<float, Form::Bilinear, HalfOpen>},
    {"interpolate-bilinear", Arithmetic::Float64, SpanAxis::Column,
     drawInterpolated<double, Form::Bilinear, Closed>,
     drawInterpolated<double, Form::Bilinear, HalfOpen>},
    {"interpolate-plane", Arithmetic::Float32, SpanAxis::Column,
     drawInterpolated<float, Form::Plane, Closed>, drawInterpolated<float, Form::Plane, HalfOpen>},
    {"interpolate-plane", Arithmetic::Float64, SpanAxis::Column,
     drawInterpolated<double, Form::Plane, Closed>,
     drawInterpolated<double, Form::Plane, HalfOpen>},
    {"interpolate-barycentric", Arithmetic::Float32, SpanAxis::Column,
     drawInterpolated<float, Form::Barycentric, Closed>,
     drawInterpolated<float, Form::Barycentric, HalfOpen>},
    {"interpolate-barycentric", Arithmetic::Float64, SpanAxis::Column,
     drawInterpolated<double, Form::Barycentric, Closed>,
     drawInterpolated<double, Form::Barycentric, HalfOpen>},
};

} // namespace

std::span<const StraightLoop> straightInterpolations() { return rows; }

} // namespace pixelplumb
