// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/words/pseudocode.h"

namespace pixelplumb {

/// A line of the listing of a method whose rule and frame are not given yet.
struct ListedLine {
    PseudocodeLine line;
    /// "closed, open", "origin top-left", "top-left with origin top-left"; empty: everywhere.
    QString where;
};

/// The lines as they read under each of the rules in a frame of either origin, each text once.
std::vector<ListedLine> underRules(const Pseudocode &code, const std::vector<FillRule> &rules);

} // namespace pixelplumb
