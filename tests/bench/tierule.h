// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <array>

namespace pixelplumb::bench {

/// Who owns a sample exactly on an edge, told by the infinitely small displacement under which the
/// sample is taken, y upward. Renderers differ in nothing but its direction; the oracle knows two
/// of them, the others are those in a mirror.
struct TieRule {
    const char *name = nullptr;
    FillRule rule = FillRule::Closed;
    bool mirrorsColumns = false; ///< x runs the other way
    bool mirrorsRows = false; ///< y runs the other way
};

/// Of two rules that fit a picture as well, the first is named.
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
