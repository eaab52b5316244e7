// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <array>
#include <string_view>

namespace pixelplumb {

/// Which pixels a right program may have otherwise than the scene's method, from the strictest on.
enum class Leeway {
    Strict, ///< none: the scene's fill rule to the letter, without rounding
    Rule, ///< those that rounding may decide; what it cannot decide is the fill rule's
    Edges, ///< also those whose sample lies on an edge, where rules differ
    Once, ///< as Edges, but a sample between triangles is one triangle's (SampleChoice)
};
inline constexpr std::array allLeeways
    = {Leeway::Strict, Leeway::Rule, Leeway::Edges, Leeway::Once};
std::string_view nameOf(Leeway leeway); ///< "strict", "rule", "edges", "once"

/// Whether the rule gives each sample between triangles to one of them.
constexpr bool isWatertight(FillRule rule)
{
    return rule != FillRule::Closed && rule != FillRule::Open;
}

/// The arithmetics whose rounding can be allowed.
inline constexpr std::array allTolerances = {Arithmetic::Float32, Arithmetic::Float64};

/// What a right program may draw, and print, otherwise than the scene's exact run.
struct Margin {
    Leeway leeway = Leeway::Rule;
    Arithmetic tolerance = Arithmetic::Float32; ///< that it computes in; exact: nothing is rounded

    bool isStrict() const { return leeway == Leeway::Strict; }
    bool leavesEdgesOpen() const { return leeway == Leeway::Edges || leeway == Leeway::Once; }

    friend bool operator==(const Margin &, const Margin &) = default;
};

} // namespace pixelplumb
