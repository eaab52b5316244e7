// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"

#include <cstdint>

namespace pixelplumb {

/// Which pixels of a frame were written at least once. Colours cannot show this: a triangle may
/// have the background's colour.
class CoverageMask {
public:
    explicit CoverageMask(const FrameSpec &spec)
        : m_covered(spec)
    {
    }

    const FrameSpec &spec() const { return m_covered.spec(); }
    /// (x, y) must lie inside the frame.
    bool covers(std::int64_t x, std::int64_t y) const { return m_covered.at(x, y) != 0; }
    void cover(std::int64_t x, std::int64_t y) { m_covered.at(x, y) = 1; }

    friend bool operator==(const CoverageMask &, const CoverageMask &) = default;

private:
    FrameMap<std::uint8_t> m_covered;
};

} // namespace pixelplumb
