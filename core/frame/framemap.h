// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <algorithm>
#include <span>
#include <vector>

namespace pixelplumb {

/// A value for each pixel of a frame, indexed by the frame's own coordinates.
template <class Value>
class FrameMap {
public:
    /// A map of no frame: it contains no pixel.
    FrameMap() = default;
    explicit FrameMap(const FrameSpec &spec, const Value &value = {})
        : m_spec(spec)
        , m_values(std::size_t(spec.width) * std::size_t(spec.height), value)
    {
    }

    const FrameSpec &spec() const { return m_spec; }
    std::size_t size() const { return m_values.size(); } ///< pixels

    bool contains(std::int64_t x, std::int64_t y) const
    {
        return !m_values.empty() && x >= m_spec.firstColumn && y >= m_spec.firstRow
            && x - m_spec.firstColumn < m_spec.width && y - m_spec.firstRow < m_spec.height;
    }
    // (x, y) must lie inside the frame.
    const Value &at(std::int64_t x, std::int64_t y) const { return m_values[indexOf(x, y)]; }
    Value &at(std::int64_t x, std::int64_t y) { return m_values[indexOf(x, y)]; }

    /// The pixels of a row of the frame, from its first column on.
    std::span<const Value> row(std::int64_t y) const
    {
        return std::span(m_values).subspan(indexOf(m_spec.firstColumn, y),
                                           std::size_t(m_spec.width));
    }
    void fill(const Value &value) { std::ranges::fill(m_values, value); }

    friend bool operator==(const FrameMap &, const FrameMap &) = default;

private:
    std::size_t indexOf(std::int64_t x, std::int64_t y) const
    {
        return std::size_t((y - m_spec.firstRow) * m_spec.width + (x - m_spec.firstColumn));
    }

    FrameSpec m_spec;
    std::vector<Value> m_values; ///< row by row
};

} // namespace pixelplumb
