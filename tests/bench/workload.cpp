// SPDX-License-Identifier: GPL-3.0-or-later
#include "workload.h"

#include "core/geometry/seededrandom.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb::bench {

namespace {

class Random : public SeededRandom {
public:
    using SeededRandom::SeededRandom;

    int between(int first, int last) { return int(SeededRandom::between(first, last)); }
    Vertex vertex(int x, int y)
    {
        const auto level = [this] { return std::uint8_t(between(darkestLevel, brightestLevel)); };
        return {latticePixel(x, y), {{level(), level(), level()}}};
    }
};

std::int64_t doubledPixelArea(const PixelPoint &a, const PixelPoint &b)
{
    return std::abs(std::int64_t(a.x) * b.y - std::int64_t(b.x) * a.y);
}

/// A triangle at a random place whose area is within a tenth of the wanted one. Shapes range from
/// equilateral to about 1 : 8.
Triangle scatteredTriangle(Random &random, FrameSize size, double area)
{
    const int reach
        = std::min({int(std::ceil(2.5 * std::sqrt(area))), size.width - 1, size.height - 1});
    const double tolerance = std::max(0.2 * area, 1.0); // of the doubled area
    while (true) {
        const PixelPoint b = {random.between(-reach, reach), random.between(-reach, reach)};
        const PixelPoint c = {random.between(-reach, reach), random.between(-reach, reach)};
        const auto [left, right] = std::minmax({0, b.x, c.x});
        const auto [low, high] = std::minmax({0, b.y, c.y});
        if (right - left >= size.width || high - low >= size.height)
            continue;
        if (std::abs(double(doubledPixelArea(b, c)) - 2 * area) > tolerance)
            continue;
        const int x = random.between(-left, size.width - 1 - right);
        const int y = random.between(-low, size.height - 1 - high);
        return {{random.vertex(x, y), random.vertex(x + b.x, y + b.y),
                 random.vertex(x + c.x, y + c.y)}};
    }
}

enum class Direction { Tall, Wide };

/// Slivers 1,009 px long and 2 to 5 px thick.
std::vector<Triangle> slivers(FrameSize size, std::size_t count, Direction direction,
                              std::uint64_t seed)
{
    Random random(seed);
    const bool tall = direction == Direction::Tall;
    const int along = tall ? size.height : size.width;
    const int across = tall ? size.width : size.height;
    const int length = std::min(1009, along - 7);
    const auto vertex
        = [&](int a, int b) { return tall ? random.vertex(b, a) : random.vertex(a, b); };
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        const int start = random.between(0, along - 1 - length);
        const int side = random.between(5, across - 6);
        const int thickness = random.between(2, 5) * (random.between(0, 1) != 0 ? 1 : -1);
        const Vertex first = vertex(start, side);
        const Vertex middle
            = vertex(start + random.between(length / 4, 3 * length / 4), side + thickness);
        const Vertex last = vertex(start + length, side + random.between(-1, 1));
        if (doubledArea(first.position, middle.position, last.position) != 0)
            triangles.push_back({{first, middle, last}});
    }
    return triangles;
}

/// A grid with jittered corners and two triangles per cell; it fills the frame from corner to
/// corner.
std::vector<Triangle> mesh(FrameSize size, int columns, int rows, std::uint64_t seed)
{
    Random random(seed);
    const auto stride = std::size_t(columns) + 1;
    std::vector<Vertex> corners;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const auto place = [&](int index, int count, int extent) {
                const int even = int(std::int64_t(index) * (extent - 1) / count);
                const int jitter = std::max(0, extent / count / 3 - 1);
                const bool border = index == 0 || index == count;
                return border ? even : even + random.between(-jitter, jitter);
            };
            const int x = place(column, columns, size.width);
            corners.push_back(random.vertex(x, place(row, rows, size.height)));
        }
    }
    std::vector<Triangle> triangles;
    for (std::size_t row = 0; row < std::size_t(rows); ++row) {
        for (std::size_t column = 0; column < std::size_t(columns); ++column) {
            const std::size_t corner = row * stride + column;
            triangles.push_back({{corners[corner], corners[corner + 1], corners[corner + stride]}});
            triangles.push_back(
                {{corners[corner + 1], corners[corner + stride + 1], corners[corner + stride]}});
        }
    }
    return triangles;
}

/// Triangles of a quarter to a half of the frame, on top of each other.
std::vector<Triangle> overdraw(FrameSize size, std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    const double frameArea = double(size.width) * size.height;
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        const auto vertex = [&] {
            const int x = random.between(0, size.width - 1);
            return random.vertex(x, random.between(0, size.height - 1));
        };
        const Triangle triangle = {{vertex(), vertex(), vertex()}};
        const double area = std::abs(double(doubledArea(triangle)))
            / (2.0 * double(unitsPerPixel) * double(unitsPerPixel));
        if (area >= frameArea / 4)
            triangles.push_back(triangle);
    }
    return triangles;
}

/// Areas from 4 to 100,000 px, equally many of each order of magnitude.
std::vector<Triangle> mixedSizes(FrameSize size, std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        const double area = 4.0 * std::pow(25000.0, random.unit());
        triangles.push_back(scatteredTriangle(random, size, area));
    }
    return triangles;
}

} // namespace

std::vector<Triangle> scatteredTriangles(FrameSize size, std::size_t count, int area,
                                         std::uint64_t seed)
{
    Random random(seed);
    std::vector<Triangle> triangles;
    triangles.reserve(count);
    while (triangles.size() < count)
        triangles.push_back(scatteredTriangle(random, size, area));
    return triangles;
}

std::vector<Workload> standardWorkloads(Extent extent)
{
    const std::size_t shorten = extent == Extent::Quick ? 20 : 1;
    const FrameSize hd = {1920, 1080};
    const FrameSize uhd = {3840, 2160};
    Random random(1);
    const Triangle half
        = {{random.vertex(2, 3), random.vertex(1913, 11), random.vertex(691, 1069)}};
    std::vector<Workload> workloads;
    const auto add
        = [&](const char *id, const char *title, FrameSize size, std::vector<Triangle> triangles) {
              workloads.push_back({QString::fromLatin1(id), QString::fromLatin1(title), size,
                                   std::move(triangles)});
          };
    add("W1", "of half the frame", hd, {half});
    add("W2", "of 1,000 px", hd, scatteredTriangles(hd, 10000 / shorten, 1000, 2));
    add("W3", "of 50 px", hd, scatteredTriangles(hd, 100000 / shorten, 50, 3));
    add("W4", "of 4 px", hd, scatteredTriangles(hd, 1000000 / shorten, 4, 4));
    add("W5t", "as slivers 1,009 px tall", hd, slivers(hd, 2000 / shorten, Direction::Tall, 5));
    add("W5w", "as slivers 1,009 px wide", hd, slivers(hd, 2000 / shorten, Direction::Wide, 6));
    add("mesh", "of a mesh with shared edges", hd, mesh(hd, 97, 53, 7));
    add("overdraw", "of a quarter to half the frame, overdrawn", hd,
        overdraw(hd, 53 / shorten + 1, 8));
    add("4K", "of 4 to 100,000 px at 3840 x 2160", uhd, mixedSizes(uhd, 10000 / shorten, 9));
    return workloads;
}

std::vector<Triangle> flattened(std::span<const Triangle> triangles)
{
    std::vector<Triangle> flat(triangles.begin(), triangles.end());
    for (Triangle &triangle : flat)
        triangle.vertices[1].colour = triangle.vertices[2].colour = triangle.vertices[0].colour;
    return flat;
}

std::int64_t coveredSamples(std::span<const Triangle> triangles)
{
    std::int64_t samples = 0;
    for (const Triangle &triangle : triangles) {
        const std::array<int, 3> order = sortedByColumn(triangle);
        const PixelPoint p0 = pixelOf(triangle.vertices[std::size_t(order[0])]);
        const PixelPoint p1 = pixelOf(triangle.vertices[std::size_t(order[1])]);
        const PixelPoint p2 = pixelOf(triangle.vertices[std::size_t(order[2])]);
        // The samples below an edge, [⌈x_a⌉, ⌈x_b⌉) columns: a sum of ⌈y⌉.
        const auto below = [](PixelPoint a, PixelPoint b) {
            const std::int64_t width = b.x - a.x;
            std::int64_t sum = 0;
            for (std::int64_t step = 0; step < width; ++step)
                sum += a.y + ceilDivide(step * (b.y - a.y), width);
            return sum;
        };
        samples += std::abs(below(p0, p2) - below(p0, p1) - below(p1, p2));
    }
    return samples;
}

} // namespace pixelplumb::bench
