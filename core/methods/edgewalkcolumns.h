// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"
#include "core/scan/edgewalk.h"

#include <vector>

namespace pixelplumb {

/// Where the colour's change along a span comes from.
enum class ColourRate {
    Bilinear, ///< from the colours and positions of the span's two bounds
    Plane, ///< from the plane through the three vertices
};

/// What the formulas of an edge walk depend on.
struct EdgeWalkTable {
    SpanAxis axis = SpanAxis::Row;
    WalkForm form = WalkForm::Accumulated;
    ColourRate rate = ColourRate::Bilinear;
};

/// What the cells of EdgeWalkRecording are, in their order.
std::vector<TraceColumn> edgeWalkSetUpColumns(const EdgeWalkTable &table);
std::vector<TraceColumn> edgeWalkSpanColumns(const EdgeWalkTable &table);
std::vector<TraceColumn> edgeWalkSampleColumns();

} // namespace pixelplumb
