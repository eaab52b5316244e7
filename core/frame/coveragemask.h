// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <vector>

namespace pixelplumb {

/// Which pixels of a frame were written at least once. Colours cannot tell: a triangle may have the
/// colour of its background.
class CoverageMask {
public:
    explicit CoverageMask(const FrameSpec &spec)
        : m_spec(spec)
        , m_covered(std::size_t(spec.width) * std::size_t(spec.height), 0)
    {
    }

    const FrameSpec &spec() const { return m_spec; }
    /// (x, y) must lie inside the frame.
    bool covers(std::int64_t x, std::int64_t y) const { return m_covered[indexOf(x, y)] != 0; }
    void cover(std::int64_t x, std::int64_t y) { m_covered[indexOf(x, y)] = 1; }

    friend bool operator==(const CoverageMask &, const CoverageMask &) = default;

private:
    std::size_t indexOf(std::int64_t x, std::int64_t y) const
    {
        return std::size_t((y - m_spec.firstRow) * m_spec.width + (x - m_spec.firstColumn));
    }

    FrameSpec m_spec;
    std::vector<std::uint8_t> m_covered;
};

} // namespace pixelplumb
