// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/difference.h"
#include "core/frame/framebuffer.h"
#include "core/frame/framemap.h"

#include <span>

namespace pixelplumb {

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
        m_counts.add(m_kinds.at(x, y), -1);
        m_kinds.at(x, y) = kind;
        m_counts.add(kind);
    }
    std::int64_t count(Difference kind) const { return m_counts.count(kind); }
    std::int64_t total() const { return m_counts.total(); }

private:
    FrameMap<Difference> m_kinds;
    DifferenceCounts m_counts;
};

} // namespace pixelplumb
