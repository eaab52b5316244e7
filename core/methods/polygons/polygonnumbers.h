// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/polygons/polygonstate.h"
#include "core/trace/numberrow.h"

#include <cstddef>

namespace pixelplumb {

/// Whether a polygon is scanned whole or broken into triangles first. Crossings may become corners
/// of the triangles; the edges of a whole polygon may be the chords of curves.
enum class PolygonForm { Whole, Chords, Triangles, CrossingTriangles };

constexpr bool isInTriangles(PolygonForm form) { return form >= PolygonForm::Triangles; }

/// How many of a row's crossings are shown. A whole polygon's row may have more.
constexpr std::size_t shownCrossings(PolygonForm form) { return isInTriangles(form) ? 2 : 6; }

NumberTable<PolygonSetUp> polygonSetUpNumbers(PolygonForm form);
NumberTable<PolygonRowState> polygonRowNumbers(PolygonForm form);
/// None for a polygon in triangles: between its bounds every sample is inside.
NumberTable<PolygonSampleState> polygonSampleNumbers(PolygonForm form);

} // namespace pixelplumb
