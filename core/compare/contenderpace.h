// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"

namespace pixelplumb {

/// How far a contender's picture is at each position of its run, which must have been recorded.
class ContenderPace {
public:
    ContenderPace(const Contest &contest, std::size_t run);

    /// The pixels that are written there, and the differences that are decided; everything else is
    /// as in the end.
    ContenderTally at(std::size_t position) const;

private:
    ContenderTally m_end;
    std::vector<std::size_t> m_written; ///< the positions from which pixels are written, ascending
    /// The positions from which differences are decided, ascending, by Difference.
    std::array<std::vector<std::size_t>, allDifferences.size()> m_differences;
};

} // namespace pixelplumb
