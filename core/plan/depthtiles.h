// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelplumb {

/// A bounding box, boundary included; lattice units from the frame's first sample. Depths are
/// levels of 0 … mostDepthLevel, on one scale for all boxes of a scene, widened to whole levels;
/// what is nearer or farther than all vertices is one level beyond.
struct DepthBox {
    std::int32_t left = 0, right = 0, low = 0, high = 0;
    std::int32_t nearest = 0, farthest = 0;
};

inline constexpr std::int32_t mostDepthLevel = (std::int32_t(1) << 30) - 1;

/// The lower left corner of a tile; lattice units from the frame's first sample.
struct TileCorner {
    std::int32_t x = 0, y = 0;
};

/// The boxes of a scene's triangles sorted into square tiles, so that only boxes in the same tile
/// need comparing. The tile size is chosen so that most boxes touch few tiles.
class DepthTiles {
public:
    /// The boxes lie within [0, width] × [0, height].
    DepthTiles(std::span<const DepthBox> boxes, std::int32_t width, std::int32_t height);

    std::size_t count() const { return m_begin.size() - 1; }
    /// The indices of the boxes that touch a tile, ascending.
    std::span<const std::uint32_t> placesIn(std::size_t tile) const
    {
        return std::span(m_places).subspan(m_begin[tile], m_begin[tile + 1] - m_begin[tile]);
    }
    TileCorner cornerOf(std::size_t tile) const
    {
        return {std::int32_t((tile % m_columns) << m_shift),
                std::int32_t((tile / m_columns) << m_shift)};
    }

private:
    std::uint64_t touchedTiles(std::span<const DepthBox> boxes) const;
    template <class Visit>
    void forEachTile(const DepthBox &box, const Visit &visit) const;

    int m_shift = 0; ///< a tile's side is 2^shift lattice units
    std::size_t m_columns = 1;
    std::vector<std::uint32_t> m_begin; ///< where each tile begins in m_places, and the end
    std::vector<std::uint32_t> m_places;
};

} // namespace pixelplumb
