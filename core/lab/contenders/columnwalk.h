// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/lab/contenders/straightloop.h"

#include <array>
#include <vector>

namespace pixelplumb {

/// Numbers that change from pixel to pixel by adding.
template <std::size_t count>
using WalkedValues = std::array<float, count>;

/// y and the values of an edge where it meets a column.
template <std::size_t count>
struct EdgeStepper {
    float y, slope;
    WalkedValues<count> value, rate;

    EdgeStepper(const LatticePoint &a, const WalkedValues<count> &atA, const LatticePoint &b,
                const WalkedValues<count> &atB, std::int64_t column)
    {
        const auto pixels = [](Lattice units) { return float(units) / float(unitsPerPixel); };
        const float width = pixels(b.x) - pixels(a.x);
        const float run = float(column) - pixels(a.x);
        slope = width == 0 ? 0 : (pixels(b.y) - pixels(a.y)) / width;
        y = pixels(a.y) + run * slope;
        for (std::size_t i = 0; i < count; ++i) {
            rate[i] = width == 0 ? 0 : (atB[i] - atA[i]) / width;
            value[i] = atA[i] + run * rate[i];
        }
    }
    void step()
    {
        y += slope;
        for (std::size_t i = 0; i < count; ++i)
            value[i] += rate[i];
    }
};

/// The assignment's column scan in float32, with half-open columns and rows, over the vertices'
/// values: calls drawColumn(x, first row, end row, values at the first row, their rates).
template <std::size_t count, class DrawColumn>
void walkColumns(const Triangle &triangle, const std::array<WalkedValues<count>, 3> &values,
                 const DrawColumn &drawColumn)
{
    using Edge = EdgeStepper<count>;
    const auto order = sortedByColumn(triangle);
    const auto at
        = [&](std::size_t i) { return triangle.vertices[std::size_t(order[i])].position; };
    const auto edge = [&](std::size_t from, std::size_t to, std::int64_t column) {
        return Edge(at(from), values[std::size_t(order[from])], at(to),
                    values[std::size_t(order[to])], column);
    };
    const bool longAbove = doubledArea(at(0), at(1), at(2)) >= 0;
    const std::int64_t begin = ceilPixel(at(0).x);
    const std::int64_t middle = ceilPixel(at(1).x);
    const std::int64_t end = ceilPixel(at(2).x);
    Edge longEdge = edge(0, 2, begin);
    const auto walk = [&](Edge shortEdge, std::int64_t from, std::int64_t to) {
        for (std::int64_t x = from; x < to; ++x) {
            const Edge &bottom = longAbove ? shortEdge : longEdge;
            const Edge &top = longAbove ? longEdge : shortEdge;
            const std::int64_t first = straightCeil(bottom.y);
            const float height = top.y - bottom.y;
            WalkedValues<count> value, rate;
            for (std::size_t i = 0; i < count; ++i) {
                rate[i] = height == 0 ? 0 : (top.value[i] - bottom.value[i]) / height;
                value[i] = bottom.value[i] + (float(first) - bottom.y) * rate[i];
            }
            drawColumn(x, first, straightCeil(top.y), value, rate);
            shortEdge.step();
            longEdge.step();
        }
    };
    walk(edge(0, 1, begin), begin, middle);
    walk(edge(1, 2, middle), middle, end);
}

inline float unitsOf(Attribute attribute)
{
    return float(double(attribute) / double(attributeOne));
}

/// One level per pixel, stored column by column, as they are walked.
template <class Level>
class ColumnMajor {
public:
    ColumnMajor(const FrameView &frame, Level level)
        : m_frame(frame)
        , m_levels(std::size_t(frame.width) * std::size_t(frame.height), level)
    {
    }
    Level *at(std::int64_t x, std::int64_t y)
    {
        return m_levels.data() + (x - m_frame.firstColumn) * m_frame.height + y - m_frame.firstRow;
    }

private:
    FrameView m_frame;
    std::vector<Level> m_levels;
};

/// Walks all triangles with the values that valuesOf(vertex) gives: calls drawColumn(colour of the
/// triangle, then the arguments above).
template <std::size_t count, class ValuesOf, class DrawColumn>
void drawTriangles(const Primitives &primitives, const ValuesOf &valuesOf,
                   const DrawColumn &drawColumn)
{
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        std::array<WalkedValues<count>, 3> values;
        for (std::size_t k = 0; k < 3; ++k)
            values[k] = valuesOf(primitives.attributes[i].vertices[k]);
        const Triangle &triangle = primitives.triangles[i];
        walkColumns<count>(triangle, values, [&](auto... column) {
            drawColumn(triangle.vertices[0].colour, column...);
        });
    }
}

} // namespace pixelplumb
