// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pixelplumb {

/// How a pixel of the finished picture differs from the truth.
enum class Difference : std::uint8_t {
    None,
    Missing, ///< the truth covers it, the kernel did not write it
    Extra, ///< the kernel wrote it, the truth does not cover it
    Colour, ///< both wrote it, with different bytes
};

/// The differences of a whole picture from the truth, a byte a pixel.
class DifferenceMap {
public:
    DifferenceMap() = default;
    explicit DifferenceMap(const FrameSpec &spec)
        : m_spec(spec)
        , m_kinds(std::size_t(spec.width) * std::size_t(spec.height), Difference::None)
    {
    }

    /// Difference::None outside the frame.
    Difference at(std::int64_t x, std::int64_t y) const
    {
        return contains(x, y) ? m_kinds[indexOf(x, y)] : Difference::None;
    }
    /// The pixels of a row of the frame, from its first column on.
    std::span<const Difference> row(std::int64_t y) const
    {
        return std::span(m_kinds).subspan(indexOf(m_spec.firstColumn, y),
                                          std::size_t(m_spec.width));
    }
    /// Takes all differences back and keeps the memory.
    void clear()
    {
        if (total() > 0)
            std::ranges::fill(m_kinds, Difference::None);
        m_counts = {};
    }
    void set(std::int64_t x, std::int64_t y, Difference kind)
    {
        --m_counts[std::size_t(m_kinds[indexOf(x, y)])];
        m_kinds[indexOf(x, y)] = kind;
        ++m_counts[std::size_t(kind)];
    }
    std::int64_t count(Difference kind) const { return m_counts[std::size_t(kind)]; }
    std::int64_t total() const
    {
        return count(Difference::Missing) + count(Difference::Extra) + count(Difference::Colour);
    }

private:
    bool contains(std::int64_t x, std::int64_t y) const
    {
        return x >= m_spec.firstColumn && y >= m_spec.firstRow
            && x - m_spec.firstColumn < m_spec.width && y - m_spec.firstRow < m_spec.height
            && !m_kinds.empty();
    }
    std::size_t indexOf(std::int64_t x, std::int64_t y) const
    {
        return std::size_t((y - m_spec.firstRow) * m_spec.width + (x - m_spec.firstColumn));
    }

    FrameSpec m_spec;
    std::vector<Difference> m_kinds;
    std::array<std::int64_t, 4> m_counts = {};
};

} // namespace pixelplumb
