// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/lines/linenumbers.h"
#include "core/scan/polygons/polygonoutline.h"
#include "core/trace/stepwords.h"

/// The numbers of a polygon's outline: those of its edges' lines, step by step.
namespace pixelplumb {

struct PolygonOutlineState : DecisionState {
    std::size_t edge = 0;
    DecisionSetUpState line;
};

NumberTable<PolygonOutlineSetUp> polygonOutlineSetUpNumbers();
NumberTable<PolygonOutlineState> polygonOutlineNumbers();

void tellLine(StepWords &words, const PolygonOutlineState &state);

} // namespace pixelplumb
