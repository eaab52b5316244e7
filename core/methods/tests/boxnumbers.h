// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/edgeteststeps.h"
#include "core/methods/words/placenumbers.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

class EdgeTestNames;

/// Appends the box of the vertices and the samples in it across the loops (Triangle Rasterization
/// slides, "Triangle rasterization implementation guidelines": bbox, left, right, top, bottom);
/// nothing where every sample of the frame is tested.
void appendBox(NumberTable<EdgeTestSetUpState> &table, const EdgeTestNames &names);

/// "x_min = max(⌈x_least⌉, 0)": how the first or the last sample of an extent comes from the box of
/// the vertices.
QString firstInBoxFormula(QChar axis, const BoxExtent &extent);
QString lastInBoxFormula(QChar axis, const BoxExtent &extent);

/// Appends x_min and x_max, or those of y: the first and the last sample, row or column that is
/// tested, with the formulas of the box where there is one.
template <class State>
void appendExtent(NumberTable<State> &table, const EdgeTestForm &form, QChar axis,
                  const QString &noun, NumberGroup group)
{
    const auto extentOf = [axis](const State &state) -> const BoxExtent & {
        return axis == u'x' ? state.columns : state.rows;
    };
    const auto row
        = [&](const QString &end, const QString &toolTip, const auto &value, auto formula) {
              table.push_back(
                  {plainNumber(axis + end, axis + end, "px", toolTip.arg(noun), {}, group),
                   [=](const State &state) { return Quantity::integer(value(extentOf(state))); },
                   [=, isBox = form.visited == VisitedSamples::BoundingBox](
                       NumberDescription &number, const State &state) {
                       if (isBox)
                           number.formula = formula(axis, extentOf(state));
                   }});
          };
    row(
        "_min", "The first %1 that is tested.",
        [](const BoxExtent &extent) { return extent.first; }, firstInBoxFormula);
    row(
        "_max", "The last %1 that is tested.",
        [](const BoxExtent &extent) { return extent.end - 1; }, lastInBoxFormula);
}

} // namespace pixelplumb
