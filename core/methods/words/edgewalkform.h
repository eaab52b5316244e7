// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/spanaxis.h"

namespace pixelplumb {

/// How the positions and colours of the edges are computed.
enum class WalkForm {
    Accumulated, ///< each span adds the slopes to the one before
    Direct, ///< each span computes y₀ + (x − x₀)·m anew
};

/// Where the colour's change along a span comes from.
enum class ColourRate {
    Bilinear, ///< from the colours and positions of the span's two bounds
    Plane, ///< from the plane through the three vertices
};

/// What the words about an edge walk depend on: names, formulas, pseudocode. Its kernel's
/// withNumbers() chooses the numbers it computes in (core/methods/walks/edgewalkkernels.h).
struct EdgeWalkForm {
    SpanAxis axis = SpanAxis::Column;
    WalkForm walk = WalkForm::Accumulated;
    ColourRate rate = ColourRate::Bilinear;
};

} // namespace pixelplumb
