// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/families/familyshapes.h"

namespace pixelplumb::familyshapes {

namespace {

/// Every triangle's distance from the border: a rounded edge may be off by less than a pixel.
constexpr Lattice border = 2 * unitsPerPixel;

/// The lowest corner of the frame, inside its border.
LatticePoint lowest(const FrameSpec &frame)
{
    const LatticePoint corner = latticePixel(frame.firstColumn, frame.firstRow);
    return {corner.x + border, corner.y + border};
}
LatticePoint highest(const FrameSpec &frame)
{
    const LatticePoint corner = latticePixel(std::int64_t(frame.firstColumn) + frame.width - 1,
                                             std::int64_t(frame.firstRow) + frame.height - 1);
    return {corner.x - border, corner.y - border};
}

/// A random place on multiples of the step from the frame's lowest place.
LatticePoint placeWithin(SeededRandom &random, const LatticePoint &low, const LatticePoint &high,
                         Lattice step)
{
    const Lattice x = low.x + random.between(0, (high.x - low.x) / step) * step;
    return {x, low.y + random.between(0, (high.y - low.y) / step) * step};
}

Triangle coloured(SeededRandom &random, const LatticePoint &a, const LatticePoint &b,
                  const LatticePoint &c)
{
    Triangle triangle = {{{{a, {}}, {b, {}}, {c, {}}}}};
    for (Vertex &vertex : triangle.vertices)
        vertex.colour = random.colour();
    return triangle;
}

bool isWithin(const FrameSpec &frame, const LatticePoint &point)
{
    const LatticePoint low = lowest(frame), high = highest(frame);
    return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
}

/// Makes triangles until `count` are good.
template <class Make, class IsGood>
std::vector<Triangle> keptOf(std::size_t count, const Make &make, const IsGood &isGood)
{
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        const Triangle triangle = make();
        if (doubledArea(triangle) != 0 && isGood(triangle))
            triangles.push_back(triangle);
    }
    return triangles;
}

bool isAnything(const Triangle &) { return true; }

} // namespace

std::vector<Triangle> scattered(SeededRandom &random, const FrameSpec &frame, std::size_t count,
                                Lattice step)
{
    const auto make = [&] {
        const LatticePoint low = lowest(frame), high = highest(frame);
        const LatticePoint a = placeWithin(random, low, high, step);
        const LatticePoint b = placeWithin(random, low, high, step);
        return coloured(random, a, b, placeWithin(random, low, high, step));
    };
    return keptOf(count, make, isAnything);
}

std::vector<Triangle> boxed(SeededRandom &random, const FrameSpec &frame, std::size_t count,
                            int smallest, int largest, Lattice step)
{
    const auto make = [&] {
        const Lattice width = random.between(smallest, largest) * unitsPerPixel;
        const Lattice height = random.between(smallest, largest) * unitsPerPixel;
        const LatticePoint last = highest(frame);
        const LatticePoint low
            = placeWithin(random, lowest(frame), {last.x - width, last.y - height}, step);
        const LatticePoint high = {low.x + width, low.y + height};
        const LatticePoint a = placeWithin(random, low, high, step);
        const LatticePoint b = placeWithin(random, low, high, step);
        return coloured(random, a, b, placeWithin(random, low, high, step));
    };
    return keptOf(count, make, isAnything);
}

std::vector<Triangle> slivers(SeededRandom &random, const FrameSpec &frame, std::size_t count)
{
    const auto make = [&] {
        const LatticePoint low = lowest(frame), high = highest(frame);
        const bool isTall = random.coin();
        const std::int64_t length
            = (isTall ? high.y - low.y : high.x - low.x) / unitsPerPixel - random.between(0, 40);
        const std::int64_t tilt = random.between(-length / 3, length / 3);
        const std::int64_t thickness = random.between(1, 3) * (random.coin() ? 1 : -1);
        const std::int64_t knee = random.between(length / 4, 3 * length / 4);
        const auto place = [&](std::int64_t along, std::int64_t across) {
            return isTall ? latticePixel(across, along) : latticePixel(along, across);
        };
        const LatticePoint start = placeWithin(random, low, high, unitsPerPixel);
        const auto from = [&](const LatticePoint &offset) {
            return LatticePoint{start.x + offset.x, start.y + offset.y};
        };
        return coloured(random, start, from(place(knee, tilt * knee / length + thickness)),
                        from(place(length, tilt)));
    };
    return keptOf(count, make, [&](const Triangle &triangle) {
        return isWithin(frame, triangle.vertices[1].position)
            && isWithin(frame, triangle.vertices[2].position);
    });
}

std::vector<Triangle> tied(SeededRandom &random, const FrameSpec &frame, std::size_t count)
{
    const auto make = [&] {
        const auto along = [&](const LatticePoint &from) {
            const std::int64_t times = random.between(10, 60);
            const std::int64_t right = random.between(-9, 9) * times;
            const std::int64_t up = random.between(-9, 9) * times;
            return LatticePoint{from.x + right * unitsPerPixel, from.y + up * unitsPerPixel};
        };
        const LatticePoint a = placeWithin(random, lowest(frame), highest(frame), unitsPerPixel);
        const LatticePoint b = along(a);
        return coloured(random, a, b, along(a));
    };
    return keptOf(count, make, [&](const Triangle &triangle) {
        return isWithin(frame, triangle.vertices[1].position)
            && isWithin(frame, triangle.vertices[2].position);
    });
}

std::vector<Triangle> large(SeededRandom &random, const FrameSpec &frame, std::size_t count)
{
    const Int128 least
        = Int128(frame.width) * frame.height * unitsPerPixel * unitsPerPixel / 2; // doubled
    const auto make = [&] {
        const LatticePoint low = lowest(frame), high = highest(frame);
        const LatticePoint a = placeWithin(random, low, high, unitsPerPixel);
        const LatticePoint b = placeWithin(random, low, high, unitsPerPixel);
        return coloured(random, a, b, placeWithin(random, low, high, unitsPerPixel));
    };
    return keptOf(count, make, [&](const Triangle &triangle) {
        return absolute(doubledArea(triangle)) >= least;
    });
}

std::vector<Triangle> mesh(SeededRandom &random, const FrameSpec &frame, int columns, int rows)
{
    const LatticePoint low = lowest(frame), high = highest(frame);
    // Corners move by up to a third of a cell, the last ones included.
    const Lattice width = 3 * (high.x - low.x) / (3 * columns + 1);
    const Lattice height = 3 * (high.y - low.y) / (3 * rows + 1);
    const auto stride = std::size_t(columns) + 1;
    std::vector<Vertex> corners;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const Lattice x = low.x + column * width + random.between(0, width / 3);
            corners.push_back(
                {{x, low.y + row * height + random.between(0, height / 3)}, random.colour()});
        }
    }
    std::vector<Triangle> triangles;
    for (std::size_t row = 0; row < std::size_t(rows); ++row) {
        for (std::size_t column = 0; column < std::size_t(columns); ++column) {
            const std::size_t at = row * stride + column;
            triangles.push_back({{corners[at], corners[at + 1], corners[at + stride]}});
            triangles.push_back(
                {{corners[at + 1], corners[at + stride + 1], corners[at + stride]}});
        }
    }
    return triangles;
}

std::vector<Triangle> slidingSliver(const FrameSpec &frame, std::size_t count)
{
    const LatticePoint low = lowest(frame), high = highest(frame);
    constexpr Lattice perFrame = unitsPerPixel / 16;
    std::vector<Triangle> motion;
    for (std::size_t i = 0; i < count; ++i) {
        const Lattice y = low.y + 40 * unitsPerPixel - Lattice(i) * perFrame;
        const Vertex a = {{low.x, y}, {{255, 0, 0}}};
        const Vertex b = {{(low.x + high.x) / 2, y + 5 * unitsPerPixel}, {{0, 255, 0}}};
        const Vertex c = {{high.x, y + 7 * unitsPerPixel}, {{0, 0, 255}}};
        motion.push_back({{a, b, c}});
    }
    return motion;
}

} // namespace pixelplumb::familyshapes
