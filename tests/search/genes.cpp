// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/recipe.h"

namespace pixelplumb::search {

namespace {

std::size_t pointCount(Figure figure)
{
    switch (figure) {
    case Figure::Triangle:
    case Figure::Slide:
    case Figure::Moved:
        return 3;
    case Figure::Fan:
        return 10;
    case Figure::Strip:
        return 8;
    case Figure::Grid:
        return std::size_t(gridSide) * gridSide;
    case Figure::TJunction:
        return 4;
    }
    return 0;
}

LatticePoint randomPoint(const Recipe &recipe, RandomNumbers &random)
{
    return {random.in(0, recipe.size.x * recipe.scale), random.in(0, recipe.size.y * recipe.scale)};
}

LatticePoint clampedToBox(const Recipe &recipe, LatticePoint point)
{
    return {std::clamp<Lattice>(point.x, 0, recipe.size.x * recipe.scale),
            std::clamp<Lattice>(point.y, 0, recipe.size.y * recipe.scale)};
}

/// A point near the segment between two others.
LatticePoint pointNear(const Recipe &recipe, const LatticePoint &a, const LatticePoint &b,
                       RandomNumbers &random)
{
    const std::int64_t part = random.in(1, 1023);
    const Lattice x = a.x + Lattice(Int128(b.x - a.x) * part / 1024);
    const Lattice y = a.x == b.x ? a.y + Lattice(Int128(b.y - a.y) * part / 1024)
                                 : a.y + Lattice(Int128(b.y - a.y) * (x - a.x) / (b.x - a.x));
    const Lattice off = random.in(-recipe.thickness, recipe.thickness);
    return clampedToBox(recipe, {x, y + off});
}

/// Points that start as a proper mesh; the search then moves them.
std::vector<LatticePoint> meshPoints(const Recipe &recipe, RandomNumbers &random)
{
    const Lattice width = recipe.size.x * recipe.scale;
    const Lattice height = recipe.size.y * recipe.scale;
    const auto jitter = [&](Lattice length) { return random.in(-length, length); };
    std::vector<LatticePoint> points;
    const std::size_t count = pointCount(recipe.figure);
    if (recipe.figure == Figure::Fan) {
        points.push_back({0, random.in(0, height)});
        for (std::size_t i = 1; i < count; ++i)
            points.push_back(
                {width - random.in(0, width / 8), height * Lattice(i - 1) / Lattice(count - 2)});
    } else if (recipe.figure == Figure::Strip) {
        for (std::size_t i = 0; i < count; ++i)
            points.push_back({width * Lattice(i) / Lattice(count - 1) + jitter(width / 40),
                              (i % 2 == 0 ? height / 4 : 3 * height / 4) + jitter(height / 8)});
    } else {
        for (int row = 0; row < gridSide; ++row) {
            for (int column = 0; column < gridSide; ++column)
                points.push_back({width * column / (gridSide - 1) + jitter(width / 12),
                                  height * row / (gridSide - 1) + jitter(height / 12)});
        }
    }
    for (LatticePoint &point : points)
        point = clampedToBox(recipe, point);
    return points;
}

/// Moves the first two points so that the edge between them passes through the sample: one some
/// steps before it, the other some steps after it.
void alignToSample(const Recipe &recipe, Genes &genes, RandomNumbers &random)
{
    const LatticePoint middle
        = {recipe.size.x / 2 + random.in(-99, 99), recipe.size.y / 2 + random.in(-99, 99)};
    const LatticePoint sample = {middle.x * recipe.scale, middle.y * recipe.scale};
    constexpr Lattice steps = 5;
    const LatticePoint step
        = {random.in(1, recipe.size.x * recipe.scale / 2 / steps - 100 * recipe.scale),
           random.in(-1, 1)
               * random.in(1, recipe.size.y * recipe.scale / 2 / steps - 100 * recipe.scale)};
    const Lattice back = random.in(1, steps);
    const Lattice on = random.in(1, steps);
    genes.points[0] = {sample.x - back * step.x, sample.y - back * step.y};
    genes.points[1] = {sample.x + on * step.x, sample.y + on * step.y};
    genes.sample = {recipe.corner.x + middle.x, recipe.corner.y + middle.y};
}

} // namespace

Genes randomGenes(const Recipe &recipe, RandomNumbers &random)
{
    Genes genes;
    for (Colour &colour : genes.colours) {
        for (std::uint8_t &channel : colour.channels)
            channel = std::uint8_t(random.oneIn(3) ? random.in(0, 255) : 255 * random.in(0, 1));
    }
    genes.sixteenths = random.in(0, 16);
    const bool isMesh = recipe.figure == Figure::Fan || recipe.figure == Figure::Strip
        || recipe.figure == Figure::Grid;
    if (isMesh) {
        genes.points = meshPoints(recipe, random);
        return genes;
    }
    for (std::size_t i = 0; i < pointCount(recipe.figure); ++i)
        genes.points.push_back(randomPoint(recipe, random));
    if (recipe.window == Window::OnSample) {
        alignToSample(recipe, genes, random);
    } else if (recipe.thickness > 0) {
        // A long first edge across the whole box, and the third point near it.
        genes.points[0].x = random.in(0, recipe.size.x * recipe.scale / 16);
        genes.points[1].x = recipe.size.x * recipe.scale - genes.points[0].x;
        genes.points[2] = pointNear(recipe, genes.points[0], genes.points[1], random);
    }
    return genes;
}

Genes mutated(const Recipe &recipe, Genes genes, RandomNumbers &random)
{
    for (std::int64_t change = random.in(1, 3); change > 0; --change) {
        const std::int64_t what = random.in(0, 9);
        if (what == 0) {
            Colour &colour = genes.colours[std::size_t(random.in(0, 2))];
            colour.channels[std::size_t(random.in(0, 2))] = std::uint8_t(random.in(0, 255));
        } else if (what == 1) {
            genes.sixteenths = random.in(0, 16);
        } else if (recipe.window == Window::OnSample && what < 5) {
            alignToSample(recipe, genes, random);
        } else if (what == 2 && recipe.thickness > 0) {
            genes.points[2] = pointNear(recipe, genes.points[0], genes.points[1], random);
        } else {
            LatticePoint &point = genes.points[std::size_t(random.in(
                recipe.window == Window::OnSample ? 2 : 0, std::int64_t(genes.points.size()) - 1))];
            // Steps of all sizes: one unit is as likely as half the box.
            const Lattice box = std::max(recipe.size.x, recipe.size.y) * recipe.scale;
            Lattice reach = 1;
            while (reach < box / 2 && !random.oneIn(4))
                reach *= 2;
            if (recipe.thickness > 0)
                reach = std::min(reach, recipe.thickness);
            point.x += random.oneIn(2) ? random.in(-reach, reach) : 0;
            point.y += random.oneIn(2) ? random.in(-reach, reach) : 0;
            point = clampedToBox(recipe, point);
        }
    }
    return genes;
}

} // namespace pixelplumb::search
