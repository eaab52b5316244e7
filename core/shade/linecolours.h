// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <algorithm>
#include <utility>

/// Smooth colour along lines, the only shapes whose colour changes from vertex to vertex: when it
/// is called for, and when it is switched off.
namespace pixelplumb {

/// Whether it is a line whose ends differ in place and colour.
inline bool isSmoothLine(const Shape &shape)
{
    return shape.kind == PrimitiveKind::Line && !shape.vertices.empty()
        && shape.vertices.front().position != shape.vertices.back().position
        && shape.vertices.front().colour != shape.vertices.back().colour;
}

/// Calls function(run) with a run's primitives as drawn: where smooth colour is forced off, each
/// line has the colour of its first vertex.
template <class Run, class Function>
auto withDrawnColours(const Run &run, const Function &function)
{
    const bool isOff = run.primitives.appearance.forced[Effect::SmoothColour] == Forcing::Off;
    if (!isOff || std::ranges::none_of(run.primitives.shapes, isSmoothLine))
        return function(run);
    Run flat = run;
    for (Shape &shape : flat.primitives.shapes) {
        if (isSmoothLine(shape))
            shape.vertices.back().colour = shape.vertices.front().colour;
    }
    return function(std::as_const(flat));
}

} // namespace pixelplumb
