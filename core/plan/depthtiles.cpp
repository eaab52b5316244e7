// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/depthtiles.h"

#include <algorithm>

namespace pixelplumb {

DepthTiles::DepthTiles(std::span<const DepthBox> boxes, std::int32_t width, std::int32_t height)
{
    // About two boxes per tile if they are spread evenly.
    constexpr std::uint64_t boxesPerTile = 2;
    const std::uint64_t area = (std::uint64_t(width) + 1) * (std::uint64_t(height) + 1);
    while ((area >> (2 * m_shift)) * boxesPerTile > boxes.size() + 1)
        ++m_shift;
    // Large boxes touch many tiles, so use fewer tiles; in the last resort one for the whole frame.
    constexpr std::uint64_t tilesPerBox = 6;
    const std::int32_t longer = std::max(width, height);
    while ((longer >> m_shift) > 0 && touchedTiles(boxes) > tilesPerBox * boxes.size())
        ++m_shift;

    m_columns = std::size_t(width >> m_shift) + 1;
    const std::size_t tiles = m_columns * (std::size_t(height >> m_shift) + 1);
    m_begin.assign(tiles + 1, 0);
    for (const DepthBox &box : boxes)
        forEachTile(box, [&](std::size_t tile) { ++m_begin[tile + 1]; });
    for (std::size_t tile = 0; tile < tiles; ++tile)
        m_begin[tile + 1] += m_begin[tile];
    m_places.resize(m_begin.back());
    std::vector<std::uint32_t> next(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        forEachTile(boxes[i], [&](std::size_t tile) { m_places[next[tile]++] = std::uint32_t(i); });
}

std::uint64_t DepthTiles::touchedTiles(std::span<const DepthBox> boxes) const
{
    std::uint64_t touched = 0;
    for (const DepthBox &box : boxes) {
        touched += std::uint64_t((box.right >> m_shift) - (box.left >> m_shift) + 1)
            * std::uint64_t((box.high >> m_shift) - (box.low >> m_shift) + 1);
    }
    return touched;
}

template <class Visit>
void DepthTiles::forEachTile(const DepthBox &box, const Visit &visit) const
{
    for (std::int32_t row = box.low >> m_shift; row <= box.high >> m_shift; ++row) {
        for (std::int32_t column = box.left >> m_shift; column <= box.right >> m_shift; ++column)
            visit(std::size_t(row) * m_columns + std::size_t(column));
    }
}

} // namespace pixelplumb
