// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/edgepixels.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

EdgePixels::EdgePixels(std::span<const Triangle> triangles, const FrameView &frame)
    : m_frame(frame)
    , m_isEdge(std::size_t(frame.width) * std::size_t(frame.height))
{
    for (const Triangle &triangle : triangles) {
        if (doubledArea(triangle) == 0)
            continue;
        for (std::size_t i = 0; i < 3; ++i)
            addEdge(triangle.vertices[i].position, triangle.vertices[(i + 1) % 3].position);
    }
    m_count = std::ranges::count(m_isEdge, 1);
    findBorders();
}

void EdgePixels::findBorders()
{
    m_firstBorder.assign(1, 0);
    for (std::int64_t x = m_frame.firstColumn; x < m_frame.endColumn(); ++x) {
        bool wasEdge = false;
        for (std::int64_t y = m_frame.firstRow; y < m_frame.endRow(); ++y) {
            const bool isEdge = contains(x, y);
            if (isEdge != wasEdge)
                m_borders.push_back(y);
            wasEdge = isEdge;
        }
        m_firstBorder.push_back(m_borders.size());
    }
}

void EdgePixels::addEdge(LatticePoint a, LatticePoint b)
{
    if (b < a)
        std::swap(a, b);
    // The columns whose closed strip, half a pixel to each side, meets the edge.
    const std::int64_t first
        = std::max<std::int64_t>(ceilPixel(a.x - halfPixel), m_frame.firstColumn);
    const std::int64_t end = std::min(floorPixel(b.x + halfPixel) + 1, m_frame.endColumn());
    const Int128 width = b.x - a.x;
    const Int128 rise = b.y - a.y;
    for (std::int64_t x = first; x < end; ++x) {
        // y·width at both ends of the part in the strip; a vertical edge lies in it entirely.
        const Lattice left = std::max(a.x, x * unitsPerPixel - halfPixel);
        const Lattice right = std::min(b.x, x * unitsPerPixel + halfPixel);
        Int128 low = width == 0 ? Int128(a.y) : a.y * width + (left - a.x) * rise;
        Int128 high = width == 0 ? Int128(b.y) : a.y * width + (right - a.x) * rise;
        if (high < low)
            std::swap(low, high);
        const Int128 pixel = (width == 0 ? Int128(1) : width) * unitsPerPixel;
        const Int128 half = pixel / 2;
        const std::int64_t lowest = std::max<std::int64_t>(
            std::int64_t(ceilDivide<Int128>(low - half, pixel)), m_frame.firstRow);
        const std::int64_t highest
            = std::min(std::int64_t(floorDivide<Int128>(high + half, pixel)), m_frame.endRow() - 1);
        if (lowest <= highest)
            std::fill_n(m_isEdge.begin() + std::ptrdiff_t(place(x, lowest)), highest - lowest + 1,
                        std::uint8_t(1));
    }
}

std::span<const LatticePoint> samplePattern(Antialiasing antialiasing)
{
    // Direct3D 11's standard patterns, y upward here.
    static constexpr std::array<LatticePoint, 4> four
        = {{{-32, -96}, {96, -32}, {-96, 32}, {32, 96}}};
    static constexpr std::array<LatticePoint, 16> sixteen = {{{16, 16},
                                                              {-16, -48},
                                                              {-48, 32},
                                                              {64, -16},
                                                              {-80, -32},
                                                              {32, 80},
                                                              {80, 48},
                                                              {48, -80},
                                                              {-32, 96},
                                                              {0, -112},
                                                              {-64, -96},
                                                              {-96, 64},
                                                              {-128, 0},
                                                              {112, -64},
                                                              {96, 112},
                                                              {-112, -128}}};
    switch (antialiasing) {
    case Antialiasing::Samples4:
        return four;
    case Antialiasing::Samples16:
        return sixteen;
    case Antialiasing::None:
    case Antialiasing::Area:
        break;
    }
    return {};
}

Triangle seenFrom(const Triangle &triangle, const LatticePoint &sample)
{
    Triangle moved = triangle;
    for (Vertex &vertex : moved.vertices)
        vertex.position = {vertex.position.x - sample.x, vertex.position.y - sample.y};
    return moved;
}

} // namespace pixelplumb
