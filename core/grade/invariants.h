// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/counterexample.h"

namespace pixelplumb {

/// What holds of every right picture of triangles, so that none has to be at hand.
enum class Invariant {
    Runs, ///< rows and columns of a triangle, and of two that make a convex whole, have no gaps
    Bounds, ///< nothing is drawn outside the triangle's box
    Range, ///< levels lie between those of the vertices
    Corners, ///< a vertex on a sample that is drawn has its colour there
    Count, ///< a triangle of whole vertices covers as many samples as Pick's theorem says
    Order, ///< in whichever order the vertices are given
    Translation, ///< moved by whole pixels, the picture moves
    Once, ///< two triangles share no sample but on their edge, and there as the rule says
};
inline constexpr std::array allInvariants
    = {Invariant::Runs,  Invariant::Bounds, Invariant::Range,       Invariant::Corners,
       Invariant::Count, Invariant::Order,  Invariant::Translation, Invariant::Once};

QString nameOf(Invariant invariant); ///< "runs", …
QString sentenceOf(Invariant invariant); ///< what should hold

struct BrokenInvariant {
    Invariant invariant = Invariant::Runs;
    Scene scene; ///< the first on which it does not hold
};

struct InvariantReport {
    std::vector<BrokenInvariant> broken; ///< each invariant once
    int checked = 0; ///< pairs of triangles
    int undrawn = 0; ///< pairs of which the source could not draw all
    std::optional<UndrawnScene> firstUndrawn;
};

/// Asks for so many random pairs of triangles that share an edge. The fill rule is that of the
/// conventions.
InvariantReport checkInvariants(const PictureSource &source, const Scene &conventions,
                                std::uint64_t seed, int pairs);

} // namespace pixelplumb
