// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightwalk.h"

/// The lines and weights by which the straight loops test samples.
namespace pixelplumb::straightlines {

/// Edge equations are printed row by row, barycentric coordinates column by column.
enum class Lines { OfEdges, OfWeights };

/// Which vertex a line faces: the order in which the lines are tested and summed up.
constexpr std::size_t facedVertex(Lines lines, std::size_t line)
{
    return lines == Lines::OfWeights ? line : (line + 2) % 3;
}

/// Whether a sample exactly on a line a·x + b·y + c belongs to the side where it is positive.
template <class Number>
bool ownsTie(StraightRule rule, const Number &a, const Number &b)
{
    if (rule == StraightRule::Closed)
        return true;
    return b == Number(0) ? a > Number(0) : b > Number(0);
}

/// Three lines a·x + b·y + c, each through the two vertices that it does not face.
template <class Number>
struct ThreeLines {
    using Three = std::array<Number, 3>;
    Three a, b, c;
    std::array<Three, 3> level; ///< R G B of the faced vertices

    ThreeLines(const Triangle &triangle, Lines order)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex &faced = triangle.vertices[facedVertex(order, i)];
            for (std::size_t channel = 0; channel < 3; ++channel)
                level[i][channel] = Number(int(faced.colour.channels[channel]));
        }
    }
    Three at(std::int64_t x, std::int64_t y) const
    {
        const auto value
            = [&](std::size_t i) { return a[i] * Number(x) + b[i] * Number(y) + c[i]; };
        return {value(0), value(1), value(2)};
    }
    const Three &perColumn() const { return a; }
    const Three &perRow() const { return b; }
    Number sum(const Number *value, std::size_t channel) const
    {
        return value[0] * level[0][channel] + value[1] * level[1][channel]
            + value[2] * level[2][channel];
    }
};

template <std::floating_point Float>
struct FloatLines : ThreeLines<Float> {
    using Number = Float;
    using typename ThreeLines<Float>::Three;
    Three atFacing; ///< the values at the vertices that face the lines
    std::array<bool, 3> owns; ///< samples exactly on the line

    FloatLines(const Triangle &triangle, Lines order, StraightRule rule)
        : ThreeLines<Float>(triangle, order)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t vertex = facedVertex(order, i);
            const auto px = [&](std::size_t k) {
                return straightPixels<Float>(triangle.vertices[(vertex + k) % 3].position.x);
            };
            const auto py = [&](std::size_t k) {
                return straightPixels<Float>(triangle.vertices[(vertex + k) % 3].position.y);
            };
            this->a[i] = py(2) - py(1);
            this->b[i] = px(1) - px(2);
            this->c[i] = px(2) * py(1) - px(1) * py(2);
            atFacing[i] = this->a[i] * px(0) + this->b[i] * py(0) + this->c[i];
            if (order == Lines::OfEdges && atFacing[i] < Float(0)) {
                for (Three *part : {&this->a, &this->b, &this->c, &atFacing})
                    (*part)[i] = Float(0) - (*part)[i];
            }
        }
        decideTies(rule);
    }
    /// Tests the lines' values at a sample, or those values over the ones at the vertices.
    template <StraightRule rule>
    bool areInside(const Float *value) const
    {
        const auto accepts = [&](std::size_t i) {
            return rule == StraightRule::Closed || owns[i] ? value[i] >= Float(0)
                                                           : value[i] > Float(0);
        };
        return accepts(0) && accepts(1) && accepts(2);
    }
    Three weights(const Three &value) const
    {
        return {value[0] / atFacing[0], value[1] / atFacing[1], value[2] / atFacing[2]};
    }
    QRgb weighted(const Three &weight) const
    {
        return pixel(this->sum(weight.data(), 0), this->sum(weight.data(), 1),
                     this->sum(weight.data(), 2));
    }
    QRgb pixel(Float red, Float green, Float blue) const
    {
        return qRgb(byteOf(red), byteOf(green), byteOf(blue));
    }

protected:
    void decideTies(StraightRule rule)
    {
        for (std::size_t i = 0; i < 3; ++i)
            owns[i] = atFacing[i] > Float(0) ? ownsTie(rule, this->a[i], this->b[i])
                                             : ownsTie(rule, -this->a[i], -this->b[i]);
    }
};

/// Edge functions, positive inside.
template <std::floating_point Float>
struct FloatEdges : FloatLines<Float> {
    static constexpr Lines order = Lines::OfEdges;

    FloatEdges(const Triangle &triangle, StraightRule rule)
        : FloatLines<Float>(triangle, order, rule)
    {
    }
    QRgb pixelAt(const std::array<Float, 3> &value) const
    {
        return this->weighted(this->weights(value));
    }
};

/// Each weight is a line over its value at the vertex.
template <std::floating_point Float>
struct FloatWeights : FloatLines<Float> {
    static constexpr Lines order = Lines::OfWeights;
    using typename FloatLines<Float>::Three;

    FloatWeights(const Triangle &triangle, StraightRule rule)
        : FloatLines<Float>(triangle, order, rule)
    {
    }
    Three at(std::int64_t x, std::int64_t y) const
    {
        return this->weights(FloatLines<Float>::at(x, y));
    }
    Three perColumn() const { return this->weights(this->a); }
    Three perRow() const { return this->weights(this->b); }
    QRgb pixelAt(const Three &weight) const { return this->weighted(weight); }
};

/// The weights of a sample inside are also at most 1.
template <std::floating_point Float>
struct FloatWeightsUpToOne : FloatWeights<Float> {
    using FloatWeights<Float>::FloatWeights;

    template <StraightRule rule>
    bool areInside(const Float *weight) const
    {
        return FloatWeights<Float>::template areInside<rule>(weight) && weight[0] <= Float(1)
            && weight[1] <= Float(1) && weight[2] <= Float(1);
    }
};

/// Each line relative to its first end, where differences are exact.
template <std::floating_point Float>
struct FloatRelative : FloatWeights<Float> {
    using typename FloatWeights<Float>::Three;
    std::array<LatticePoint, 3> from;

    FloatRelative(const Triangle &triangle, StraightRule rule)
        : FloatWeights<Float>(triangle, rule)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            from[i] = triangle.vertices[(i + 1) % 3].position;
            const LatticePoint &to = triangle.vertices[(i + 2) % 3].position;
            const LatticePoint &facing = triangle.vertices[i].position;
            this->a[i] = straightPixels<Float>(to.y - from[i].y);
            this->b[i] = straightPixels<Float>(from[i].x - to.x);
            this->atFacing[i] = valueAt(i, facing);
        }
        this->decideTies(rule);
    }
    Three at(std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        return this->weights({valueAt(0, sample), valueAt(1, sample), valueAt(2, sample)});
    }

private:
    Float valueAt(std::size_t i, const LatticePoint &point) const
    {
        return this->a[i] * straightPixels<Float>(point.x - from[i].x)
            + this->b[i] * straightPixels<Float>(point.y - from[i].y);
    }
};

/// Edge functions in 64-bit integers, positive inside; colours are the plane's: the weighted sum
/// over the doubled area, rounded by one division.
template <Lines orderOfLines>
struct ExactLines : ThreeLines<std::int64_t> {
    using Number = std::int64_t;
    static constexpr Lines order = orderOfLines;
    std::int64_t area;
    Three least; ///< of the values that count as inside

    ExactLines(const Triangle &triangle, StraightRule rule)
        : ThreeLines(triangle, order)
        , area(std::int64_t(doubledArea(triangle)))
    {
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t vertex = facedVertex(order, i);
            const LatticePoint &p = triangle.vertices[(vertex + 1) % 3].position;
            const LatticePoint &q = triangle.vertices[(vertex + 2) % 3].position;
            a[i] = sign * (p.y - q.y) * unitsPerPixel;
            b[i] = sign * (q.x - p.x) * unitsPerPixel;
            c[i] = sign * (p.x * q.y - q.x * p.y);
            least[i] = ownsTie(rule, a[i], b[i]) ? 0 : 1;
        }
    }
    template <StraightRule rule>
    bool areInside(const std::int64_t *e) const
    {
        if constexpr (rule == StraightRule::Closed)
            return (e[0] | e[1] | e[2]) >= 0;
        else
            return ((e[0] - least[0]) | (e[1] - least[1]) | (e[2] - least[2])) >= 0;
    }
    QRgb pixelAt(const Three &e) const
    {
        return pixel(sum(e.data(), 0), sum(e.data(), 1), sum(e.data(), 2));
    }
    QRgb pixel(std::int64_t red, std::int64_t green, std::int64_t blue) const
    {
        return straightPixelOf({red, green, blue}, area);
    }
};

} // namespace pixelplumb::straightlines
