// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/writecount.h"

#include "core/frame/framebuffer.h"
#include "core/scan/walks/columndrawing.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::uint32_t colours = 0xffffff; ///< besides black, which the frame is cleared to
constexpr std::size_t trianglesBetweenProgress = 1024;

/// The pixels of one colour in the triangle's bounding box.
std::uint64_t countInBox(const Triangle &triangle, QRgb colour, const FrameView &frame)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    const auto firstColumn = std::max<std::int64_t>(ceilPixel(left), frame.firstColumn);
    const auto endColumn = std::min<std::int64_t>(floorPixel(right) + 1, frame.endColumn());
    const auto firstRow = std::max<std::int64_t>(ceilPixel(low), frame.firstRow);
    const auto endRow = std::min<std::int64_t>(floorPixel(high) + 1, frame.endRow());
    std::uint64_t count = 0;
    for (std::int64_t y = firstRow; y < endRow && firstColumn < endColumn; ++y) {
        const QRgb *const row = frame.at(firstColumn, y);
        count += std::uint64_t(std::count(row, row + (endColumn - firstColumn), colour));
    }
    return count;
}

} // namespace

std::optional<std::uint64_t> countWrites(std::span<const Triangle> triangles, FillRule rule,
                                         const FrameSpec &spec, const ProgressListener &listener)
{
    FrameSpec black = spec;
    black.background = {};
    FrameBuffer buffer(black);
    const ScanSettings settings{Arithmetic::Exact, rule, ByteRounding::Nearest};
    std::uint64_t writes = 0;
    // Each triangle is drawn in its own colour, and the pixels of that colour afterwards are its
    // own.
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i % trianglesBetweenProgress == 0 && !goesOn(listener, {JobPhase::Measuring, 0, 0}))
            return std::nullopt;
        const auto number = std::uint32_t(i % colours);
        if (number == 0)
            buffer.clear();
        Triangle triangle = triangles[i];
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = unpacked(number + 1);
        drawColumns(std::span(&triangle, 1), settings, buffer.view());
        writes += countInBox(triangle, packed(triangle.vertices[0].colour), buffer.view());
    }
    return writes;
}

} // namespace pixelplumb
