// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgeteststeps.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

class EdgeTestNames;

/// Appends the box of the vertices and the samples in it across the loops (Triangle Rasterization
/// slides, "Triangle rasterization implementation guidelines": bbox, left, right, top, bottom);
/// nothing where every sample of the frame is tested.
void appendBox(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names);

/// "x_min = max(⌈x_least⌉, 0)": how the first or the last sample along an axis comes from the box
/// of the vertices. `clippedTo` is the sample at the frame's border where the box is clipped there.
QString firstInBoxFormula(QChar axis, BoxRounding rounding, std::optional<std::int64_t> clippedTo);
QString lastInBoxFormula(QChar axis, BoxRounding rounding, std::optional<std::int64_t> clippedTo);

} // namespace pixelplumb
