// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

#include <cstddef>
#include <vector>

namespace pixelplumb {

/// Whether a polygon is scanned as it is or broken into triangles first.
enum class PolygonForm { Whole, Triangles };

/// How many of a row's crossings are cells. A whole polygon's row may have more.
constexpr std::size_t shownCrossings(PolygonForm form)
{
    return form == PolygonForm::Triangles ? 2 : 6;
}

/// Of each: where it is, which edge, and the three numbers that it was computed from.
inline constexpr std::size_t cellsPerCrossing = 5;

std::vector<TraceColumn> polygonSetUpColumns(PolygonForm form);
std::vector<TraceColumn> polygonRowColumns(PolygonForm form);
/// None of a polygon in triangles: between its bounds every sample is inside.
std::vector<TraceColumn> polygonSampleColumns(PolygonForm form);

} // namespace pixelplumb
