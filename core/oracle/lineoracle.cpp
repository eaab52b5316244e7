// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/lineoracle.h"

#include "core/oracle/truepixel.h"

#include <algorithm>

namespace pixelplumb::oracle {

LatticePoint nearestPixel(const LatticePoint &position)
{
    return {floorPixel(position.x + halfPixel), floorPixel(position.y + halfPixel)};
}

TrueLine::TrueLine(const Vertex &a, const Vertex &b)
    : m_isSteep(absolute(b.position.y - a.position.y) >= absolute(b.position.x - a.position.x))
    , m_a(a)
    , m_b(b)
{
    if (m_isSteep) {
        std::swap(m_a.position.x, m_a.position.y);
        std::swap(m_b.position.x, m_b.position.y);
    }
    if (m_b.position.x < m_a.position.x)
        std::swap(m_a, m_b);
}

Int128 TrueLine::scaledAt(std::int64_t along) const
{
    const Int128 width = m_b.position.x - m_a.position.x;
    const Int128 height = m_b.position.y - m_a.position.y;
    const Int128 run = Int128(along) * unitsPerPixel - m_a.position.x;
    // y = (Ya·ΔX + run·ΔY) / (ΔX·S)
    return 2 * (m_a.position.y * width + run * height) + width * unitsPerPixel;
}

std::int64_t TrueLine::nearestAt(std::int64_t along) const
{
    const Int128 width = m_b.position.x - m_a.position.x;
    if (width == 0)
        return floorPixel(m_a.position.y + halfPixel);
    return std::int64_t(floorDivide<Int128>(scaledAt(along), 2 * width * unitsPerPixel));
}

bool TrueLine::isMidwayAt(std::int64_t along) const
{
    const Int128 width = m_b.position.x - m_a.position.x;
    if (width == 0)
        return latticePixel(0, floorPixel(m_a.position.y + halfPixel)).y
            == m_a.position.y + halfPixel;
    return scaledAt(along) % (2 * width * unitsPerPixel) == 0;
}

Colour TrueLine::colourAt(std::int64_t along, ByteRounding rounding) const
{
    const Int128 width = m_b.position.x - m_a.position.x;
    if (width == 0)
        return m_a.colour;
    const Int128 run = Int128(along) * unitsPerPixel - m_a.position.x;
    const Int128 bias = rounding == ByteRounding::Nearest ? width : 0;
    Colour colour;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Int128 from = m_a.colour.channels[channel];
        const Int128 rise = m_b.colour.channels[channel] - from;
        colour.channels[channel]
            = std::uint8_t(floorDivide<Int128>(2 * (from * width + run * rise) + bias, 2 * width));
    }
    return colour;
}

bool lineCovers(const Shape &line, std::int64_t x, std::int64_t y)
{
    const TrueLine truth(line.vertices[0], line.vertices[1]);
    const std::int64_t along = truth.isSteep() ? y : x;
    const std::int64_t across = truth.isSteep() ? x : y;
    return along >= truth.first() && along < truth.end() && truth.nearestAt(along) == across;
}

void drawLine(const Shape &line, ByteRounding rounding, FrameView frame)
{
    const TrueLine truth(line.vertices[0], line.vertices[1]);
    const bool isSteep = truth.isSteep();
    const std::int64_t first
        = std::max<std::int64_t>(truth.first(), isSteep ? frame.firstRow : frame.firstColumn);
    const std::int64_t end = std::min(truth.end(), isSteep ? frame.endRow() : frame.endColumn());
    for (std::int64_t along = first; along < end; ++along) {
        const std::int64_t across = truth.nearestAt(along);
        writeTruePixel(frame, isSteep ? across : along, isSteep ? along : across,
                       truth.colourAt(along, rounding));
    }
}

bool pointsCover(const Shape &points, std::int64_t x, std::int64_t y)
{
    return std::ranges::any_of(points.vertices, [&](const Vertex &vertex) {
        return nearestPixel(vertex.position) == LatticePoint{x, y};
    });
}

void drawPoints(const Shape &points, FrameView frame)
{
    for (const Vertex &vertex : points.vertices) {
        const LatticePoint pixel = nearestPixel(vertex.position);
        writeTruePixel(frame, pixel.x, pixel.y, vertex.colour);
    }
}

} // namespace pixelplumb::oracle
