// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/oracle.h"

/// A column of a triangle in exact numbers, each computed from the vertices alone.
namespace pixelplumb::oracle {

namespace {

/// numerator / (width · unitsPerPixel) is the edge's y at a column; width > 0.
struct EdgeAtColumn {
    Int128 numerator;
    Int128 denominator;
};

EdgeAtColumn ordinateAt(const Vertex &a, const Vertex &b, std::int64_t x)
{
    const Int128 width = b.position.x - a.position.x;
    const Int128 height = b.position.y - a.position.y;
    const Int128 run = Int128(x) * unitsPerPixel - a.position.x;
    return {a.position.y * width + run * height, width * unitsPerPixel};
}

struct EdgeValues {
    Quantity y;
    std::array<Quantity, 3> colour;
};

EdgeValues valuesAt(const Vertex &a, const Vertex &b, std::int64_t x)
{
    EdgeValues values;
    const EdgeAtColumn ordinate = ordinateAt(a, b, x);
    values.y = Quantity::rational(ordinate.numerator, ordinate.denominator);
    const Int128 width = b.position.x - a.position.x;
    const Int128 run = Int128(x) * unitsPerPixel - a.position.x;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Int128 from = a.colour.channels[channel];
        const Int128 rise = b.colour.channels[channel] - from;
        values.colour[channel] = Quantity::rational(from * width + rise * run, width);
    }
    return values;
}

EdgeValues valuesOf(const Vertex &vertex)
{
    EdgeValues values;
    values.y = Quantity::rational(vertex.position.y, unitsPerPixel);
    for (std::size_t channel = 0; channel < 3; ++channel)
        values.colour[channel] = Quantity::integer(vertex.colour.channels[channel]);
    return values;
}

/// ∂level/∂y of the plane through the three vertices, levels per row.
Quantity verticalRate(const Triangle &triangle, std::size_t channel)
{
    const Int128 area = doubledArea(triangle);
    Int128 numerator = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        // A vertex's weight changes with y in proportion to the opposite edge's extent in x.
        const Lattice from = triangle.vertices[(i + 1) % 3].position.x;
        const Lattice to = triangle.vertices[(i + 2) % 3].position.x;
        numerator += Int128(triangle.vertices[i].colour.channels[channel]) * (to - from);
    }
    numerator *= unitsPerPixel;
    return Quantity::rational(area < 0 ? -numerator : numerator, absolute(area));
}

std::int64_t floorOf(const Quantity &quantity)
{
    return std::int64_t(floorDivide(quantity.numerator(), quantity.denominator()));
}

std::int64_t ceilOf(const Quantity &quantity)
{
    return std::int64_t(ceilDivide(quantity.numerator(), quantity.denominator()));
}

} // namespace

std::optional<ExactColumn> columnAt(const Triangle &triangle, FillRule rule, std::int64_t x)
{
    const std::array<int, 3> order = sortedByColumn(triangle);
    const Vertex &p0 = triangle.vertices[std::size_t(order[0])];
    const Vertex &p1 = triangle.vertices[std::size_t(order[1])];
    const Vertex &p2 = triangle.vertices[std::size_t(order[2])];
    const Int128 along = Int128(x) * unitsPerPixel;
    if (along < p0.position.x || along > p2.position.x)
        return std::nullopt;

    const bool vertical = p0.position.x == p2.position.x;
    const Int128 area = doubledArea(p0.position, p1.position, p2.position);
    EdgeValues onLong = vertical ? valuesOf(p2) : valuesAt(p0, p2, x);
    EdgeValues onShort;
    if (vertical)
        onShort = valuesOf(p0);
    else if (area == 0)
        onShort = onLong;
    else if (along < p1.position.x)
        onShort = valuesAt(p0, p1, x);
    else
        onShort = p1.position.x == p2.position.x ? valuesOf(p1) : valuesAt(p1, p2, x);

    const bool longAbove = area >= 0;
    ExactColumn column;
    column.x = x;
    column.yBottom = longAbove ? onShort.y : onLong.y;
    column.yTop = longAbove ? onLong.y : onShort.y;
    column.colourBottom = longAbove ? onShort.colour : onLong.colour;
    column.colourTop = longAbove ? onLong.colour : onShort.colour;
    const Int128 height = p2.position.y - p0.position.y;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Int128 rise = Int128(p2.colour.channels[channel]) - p0.colour.channels[channel];
        if (area != 0)
            column.colourRate[channel] = verticalRate(triangle, channel);
        else if (vertical && height != 0)
            column.colourRate[channel] = Quantity::rational(rise * unitsPerPixel, height);
        else
            column.colourRate[channel] = Quantity::integer(0);
    }
    column.firstRow = rule == FillRule::Open ? floorOf(column.yBottom) + 1 : ceilOf(column.yBottom);
    column.endRow = rule == FillRule::Closed ? floorOf(column.yTop) + 1 : ceilOf(column.yTop);
    return column;
}

bool hasTie(const Triangle &triangle, std::int64_t x)
{
    const Int128 along = Int128(x) * unitsPerPixel;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex *a = &triangle.vertices[i];
        const Vertex *b = &triangle.vertices[(i + 1) % 3];
        if (a->position.x > b->position.x)
            std::swap(a, b);
        if (along < a->position.x || along > b->position.x)
            continue;
        if (a->position.x == b->position.x) {
            const auto [low, high] = std::minmax(a->position.y, b->position.y);
            if (ceilPixel(low) <= floorPixel(high))
                return true;
            continue;
        }
        const EdgeAtColumn ordinate = ordinateAt(*a, *b, x);
        if (ordinate.numerator % ordinate.denominator == 0)
            return true;
    }
    return false;
}

} // namespace pixelplumb::oracle
