// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/shade/shadingnumber.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pixelplumb {

/// The greatest level of a depth format; 0 for the kernel's own numbers.
constexpr std::uint32_t greatestDepthLevel(DepthFormat format)
{
    return std::uint32_t((std::uint64_t(1) << unsigned(format)) - 1);
}

/// The nearest depth so far of each sample of a frame: the kernel's own numbers, or levels. Only
/// the kind in use has memory, and neither has where no depth is compared.
template <class N>
class DepthBuffer {
public:
    using Depth = typename N::Depth;

    DepthBuffer(const FrameView &frame, DepthTest test)
        : m_firstColumn(frame.firstColumn)
        , m_firstRow(frame.firstRow)
        , m_height(frame.height)
    {
        const std::size_t size = std::size_t(frame.width) * std::size_t(frame.height);
        if (test == DepthTest::Number)
            m_numbers.assign(size, farthest());
        else if (test == DepthTest::Levels)
            m_levels.assign(size, std::numeric_limits<std::uint32_t>::max());
    }

    /// The depths up a column, from a row on: kernels walk columns.
    Depth *numbersAt(std::int64_t x, std::int64_t y) { return m_numbers.data() + place(x, y); }
    std::uint32_t *levelsAt(std::int64_t x, std::int64_t y)
    {
        return m_levels.data() + place(x, y);
    }

    std::size_t bytes() const
    {
        return m_numbers.size() * sizeof(Depth) + m_levels.size() * sizeof(std::uint32_t);
    }

    static Depth farthest()
    {
        if constexpr (N::isExact)
            return {};
        else
            return std::numeric_limits<Depth>::infinity();
    }

private:
    std::size_t place(std::int64_t x, std::int64_t y) const
    {
        return std::size_t(x - m_firstColumn) * std::size_t(m_height) + std::size_t(y - m_firstRow);
    }

    std::int64_t m_firstColumn;
    std::int64_t m_firstRow;
    std::int64_t m_height;
    std::vector<Depth> m_numbers;
    std::vector<std::uint32_t> m_levels;
};

} // namespace pixelplumb
