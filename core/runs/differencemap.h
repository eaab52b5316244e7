// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/frame/framemap.h"

#include <array>
#include <span>

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
        : m_kinds(spec)
    {
    }

    /// Difference::None outside the frame.
    Difference at(std::int64_t x, std::int64_t y) const
    {
        return m_kinds.contains(x, y) ? m_kinds.at(x, y) : Difference::None;
    }
    /// The pixels of a row of the frame, from its first column on.
    std::span<const Difference> row(std::int64_t y) const { return m_kinds.row(y); }
    /// Clears all differences and keeps the memory.
    void clear()
    {
        if (total() > 0)
            m_kinds.fill(Difference::None);
        m_counts = {};
    }
    void set(std::int64_t x, std::int64_t y, Difference kind)
    {
        --m_counts[std::size_t(m_kinds.at(x, y))];
        m_kinds.at(x, y) = kind;
        ++m_counts[std::size_t(kind)];
    }
    std::int64_t count(Difference kind) const { return m_counts[std::size_t(kind)]; }
    std::int64_t total() const
    {
        return count(Difference::Missing) + count(Difference::Extra) + count(Difference::Colour);
    }

private:
    FrameMap<Difference> m_kinds;
    std::array<std::int64_t, 4> m_counts = {};
};

} // namespace pixelplumb
