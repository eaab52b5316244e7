// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelplumb {

/// A bounding box, its boundary included; lattice units from the frame's first sample.
struct UnitBox {
    std::int32_t left = 0, right = 0, low = 0, high = 0;

    bool meets(const UnitBox &other) const
    {
        return left <= other.right && other.left <= right && low <= other.high && other.low <= high;
    }
};

/// A box in a tile, and which of all boxes it is.
struct TiledBox {
    UnitBox box;
    std::uint32_t place = 0;
};

/// The boxes of a scene's triangles sorted into square tiles, so that only those of a tile need to
/// be compared with each other. A tile is chosen so that most boxes touch few of them.
class DepthTiles {
public:
    /// Boxes within [0, width] × [0, height].
    DepthTiles(std::span<const UnitBox> boxes, std::int32_t width, std::int32_t height);

    std::size_t count() const { return m_begin.size() - 1; }
    /// Those that touch a tile, in ascending places.
    std::span<const TiledBox> boxesOf(std::size_t tile) const
    {
        return std::span(m_boxes).subspan(m_begin[tile], m_begin[tile + 1] - m_begin[tile]);
    }
    /// The tile of a point: of all tiles that two boxes share, one has the lower left corner of
    /// what they share.
    std::size_t tileAt(std::int32_t x, std::int32_t y) const
    {
        return std::size_t(y >> m_shift) * m_columns + std::size_t(x >> m_shift);
    }

private:
    std::uint64_t touchedTiles(std::span<const UnitBox> boxes) const;
    template <class Visit>
    void forEachTile(const UnitBox &box, const Visit &visit) const;

    int m_shift = 0; ///< a tile's side is 2^shift lattice units
    std::size_t m_columns = 1;
    std::vector<std::uint32_t> m_begin; ///< of each tile in m_boxes, and the end
    std::vector<TiledBox> m_boxes; ///< side by side: they are compared by the million
};

} // namespace pixelplumb
