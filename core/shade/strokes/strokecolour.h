// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

#include <algorithm>

namespace pixelplumb {

/// The colour of a stroke at a point. A line's colour changes evenly from end to end, by the foot
/// of the perpendicular, and stays the end's colour beyond it; a curve has its first vertex's
/// colour.
class StrokeColour {
public:
    /// The position along a line, t = run/length: 0 … 1; 0 on curves.
    struct Place {
        Int128 run = 0;
        Int128 length = 1;
    };

    StrokeColour(const Shape &shape, ByteRounding rounding)
        : m_isLine(shape.kind == PrimitiveKind::Line)
        , m_first(shape.vertices.front())
        , m_last(shape.vertices.back())
        , m_rounding(rounding)
    {
    }

    /// The place of a pixel's sample, displaced by an offset (1/256 px).
    Place placeOf(std::int64_t x, std::int64_t y, const LatticePoint &offset) const
    {
        const Int128 dx = m_last.position.x - m_first.position.x;
        const Int128 dy = m_last.position.y - m_first.position.y;
        const Int128 length = dx * dx + dy * dy;
        if (!m_isLine || length == 0)
            return {};
        const LatticePoint sample = latticePixel(x, y);
        const Int128 run = (sample.x + offset.x - m_first.position.x) * dx
            + (sample.y + offset.y - m_first.position.y) * dy;
        return {std::clamp<Int128>(run, 0, length), length};
    }

    std::array<std::int64_t, 3> levelsAt(const Place &place) const
    {
        const Int128 bias = m_rounding == ByteRounding::Nearest ? place.length : 0;
        std::array<std::int64_t, 3> levels;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const Int128 from = m_first.colour.channels[i];
            const Int128 change = m_isLine ? m_last.colour.channels[i] - from : Int128(0);
            levels[i] = std::int64_t(floorDivide<Int128>(
                2 * (from * place.length + change * place.run) + bias, 2 * place.length));
        }
        return levels;
    }
    Colour colourAt(const Place &place) const
    {
        const std::array<std::int64_t, 3> levels = levelsAt(place);
        return {{std::uint8_t(levels[0]), std::uint8_t(levels[1]), std::uint8_t(levels[2])}};
    }

private:
    bool m_isLine;
    Vertex m_first, m_last;
    ByteRounding m_rounding;
};

} // namespace pixelplumb
