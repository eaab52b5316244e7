// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// One formula of the channels. Red, green and blue go the same way, so that what they share, the
/// symbols, need be read only once.
struct ChannelFormula {
    QString symbols; ///< with C for the channel: "C ← C + ΔC"
    std::vector<const FormulaLine *> lines; ///< at most one a channel
};

/// The colour formulas of an explanation, in the order of their first lines, which must outlive
/// them.
std::vector<ChannelFormula> channelFormulas(std::span<const FormulaLine> lines);

/// The channel of a line's subject; none of a line that is no colour's.
std::optional<QChar> channelOf(const FormulaLine &line);

} // namespace pixelplumb
