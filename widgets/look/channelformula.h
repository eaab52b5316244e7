// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// One formula of the channels. Red, green and blue share the symbols, which then need to be read
/// only once.
struct ChannelFormula {
    QString symbols; ///< with C for the channel: "C ← C + ΔC"
    std::vector<const FormulaLine *> lines; ///< at most one per channel
};

/// Groups the colour formulas of an explanation, in the order of their first lines. `lines` must
/// outlive the result.
std::vector<ChannelFormula> channelFormulas(std::span<const FormulaLine> lines);

/// The channel of a line's subject; none where the subject is no colour.
std::optional<QChar> channelOf(const FormulaLine &line);

} // namespace pixelplumb
