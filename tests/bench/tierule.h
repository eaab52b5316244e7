// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <array>

namespace pixelplumb::bench {

/// Who owns a sample exactly on an edge, expressed as the infinitely small displacement at which
/// the sample is taken, y upward. Renderers differ only in its direction; the oracle knows two
/// directions, the others are mirror images of these.
struct TieRule {
    const char *name = nullptr;
    FillRule rule = FillRule::Closed;
    bool mirrorsColumns = false; ///< x runs to the left
    bool mirrorsRows = false; ///< y runs downward
};

/// If two rules fit a picture equally well, the first one is named.
inline constexpr std::array<TieRule, 9> tieRules = {{
    {"half-open-column", FillRule::HalfOpenColumn, false, false},
    {"top-left", FillRule::TopLeft, false, false},
    {"closed", FillRule::Closed, false, false},
    {"(+ε, +ε²)", FillRule::TopLeft, false, true},
    {"(−ε, −ε²)", FillRule::TopLeft, true, false},
    {"(−ε, +ε²)", FillRule::TopLeft, true, true},
    {"(+ε², −ε)", FillRule::HalfOpenColumn, false, true},
    {"(−ε², +ε)", FillRule::HalfOpenColumn, true, false},
    {"(−ε², −ε)", FillRule::HalfOpenColumn, true, true},
}};

} // namespace pixelplumb::bench
