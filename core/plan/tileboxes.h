// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/depthtiles.h"

#include <array>

namespace pixelplumb {

/// Which pairs of boxes need no check when they meet.
struct SettledPairs {
    bool inOrder = false; ///< pairs whose later box is nowhere farther than the earlier one
    bool inQuestion = false; ///< pairs of which both are already in question
};

/// The boxes of one tile, coordinate by coordinate, so that several are compared at once: there are
/// millions of pairs, and a branch for each would be mispredicted more often than not.
class TileBoxes {
public:
    /// `places` are the indices in `boxes` of those that touch the tile; `inQuestion` is by place.
    /// Memory is reused from tile to tile.
    void take(std::span<const DepthBox> boxes, std::span<const std::uint32_t> places,
              const TileCorner &corner, const std::vector<bool> &inQuestion);

    void setInQuestion(std::size_t box) { m_inQuestion[box] = -1; }

    /// Returns how many boxes before `later` meet it, boundaries included, with the lower left
    /// corner of their intersection in this tile: of all tiles that both touch, exactly one has it.
    /// Calls `visit` with those that are not settled, ascending.
    template <class Visit>
    std::int64_t forEachMeeting(std::size_t later, SettledPairs settled, const Visit &visit) const
    {
        std::int64_t count = 0;
        for (std::size_t first = 0; first < later; first += together) {
            const Group apart = apartFrom(first, later);
            std::int32_t meeting = 0;
            for (const std::int32_t each : apart)
                meeting += each + 1;
            if (meeting == 0)
                continue;
            count += meeting;
            const Group open = openFrom(first, later, settled, apart);
            for (std::size_t i = 0; i < together; ++i) {
                if (open[i] >= 0)
                    visit(first + i);
            }
        }
        return count;
    }

private:
    static constexpr std::size_t together = 8;
    using Group = std::array<std::int32_t, together>;

    /// For the boxes first, first + 1, …: 0 where they come before the later one and meet it here,
    /// else −1. No difference exceeds 32 bits.
    Group apartFrom(std::size_t first, std::size_t later) const
    {
        const std::int32_t left = m_left[later], right = m_right[later];
        const std::int32_t low = m_low[later], high = m_high[later];
        const std::int32_t outside = m_outside[later];
        const auto before = std::int32_t(later - first) - 1;
        Group apart;
        for (std::size_t i = 0; i < together; ++i) {
            const std::size_t at = first + i;
            apart[i]
                = ((right - m_left[at]) | (m_right[at] - left) | (high - m_low[at])
                   | (m_high[at] - low) | -(m_outside[at] & outside) | (before - std::int32_t(i)))
                >> 31;
        }
        return apart;
    }

    /// Negative where the boxes are apart or the pair is settled.
    Group openFrom(std::size_t first, std::size_t later, SettledPairs settled,
                   const Group &apart) const
    {
        const std::int32_t farthest = settled.inOrder ? m_farthest[later] : mostDepthLevel + 1;
        const std::int32_t inQuestion = settled.inQuestion ? m_inQuestion[later] : 0;
        Group open;
        for (std::size_t i = 0; i < together; ++i) {
            const std::size_t at = first + i;
            open[i] = apart[i] | (farthest - m_nearest[at] - 1) | (m_inQuestion[at] & inQuestion);
        }
        return open;
    }

    // One entry per box, padded to whole groups.
    std::vector<std::int32_t> m_left, m_right, m_low, m_high, m_nearest, m_farthest;
    std::vector<std::int32_t> m_outside; ///< 1: begins left of the tile, 2: below it
    std::vector<std::int32_t> m_inQuestion; ///< −1, else 0
};

} // namespace pixelplumb
