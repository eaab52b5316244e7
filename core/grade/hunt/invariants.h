// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/hunt/counterexample.h"

namespace pixelplumb {

/// What holds for every right picture of triangles, so that no right picture is needed.
enum class Invariant {
    Runs, ///< rows and columns of a triangle, and of two with a convex union, have no gaps
    Bounds, ///< nothing is drawn outside the triangle's bounding box
    Range, ///< levels lie between those of the vertices
    Corners, ///< a vertex on a drawn sample has its colour there
    Count, ///< a triangle with whole vertices covers as many samples as Pick's theorem says
    Order, ///< the order of the vertices does not matter
    Translation, ///< moving by whole pixels moves the picture
    Once, ///< two triangles share only samples on their edge, and those as the rule says
};
inline constexpr std::array allInvariants
    = {Invariant::Runs,  Invariant::Bounds, Invariant::Range,       Invariant::Corners,
       Invariant::Count, Invariant::Order,  Invariant::Translation, Invariant::Once};

QString nameOf(Invariant invariant); ///< "runs", …
QString sentenceOf(Invariant invariant); ///< what should hold

struct BrokenInvariant {
    Invariant invariant = Invariant::Runs;
    Scene scene; ///< the first that breaks it
};

struct InvariantReport {
    std::vector<BrokenInvariant> broken; ///< each invariant once
    int checked = 0; ///< pairs of triangles
    int undrawn = 0; ///< pairs that the source could not fully draw
    std::optional<UndrawnScene> firstUndrawn;
};

/// Checks `pairs` random pairs of triangles that share an edge, under the conventions' fill rule.
InvariantReport checkInvariants(const PictureSource &source, const Scene &conventions,
                                std::uint64_t seed, int pairs);

} // namespace pixelplumb
