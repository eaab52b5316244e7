// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/tracediff.h"
#include "core/runs/tracedscene.h"

#include <memory>
#include <tuple>
#include <vector>

namespace pixelplumb {

/// The kind of a line (none: a pixel), and its x and y.
using Place = std::tuple<std::optional<SpanAxis>, std::int64_t, std::int64_t>;

/// The line that a program should print for a step of ours.
struct RightLine {
    Place place;
    std::size_t primitive = 0;
    std::size_t step = 0;
    std::vector<Quantity> numbers;
    double drift = 0; ///< allowed error of the numbers; infinite where they may be anything
    bool isAskedFor = true; ///< false: optional
};

/// The scene's right run with numbers of these kinds, by its own method where that has them. Null
/// where no method has.
std::shared_ptr<const TracedScene> rightRunOf(Scene scene, const LineKinds &kinds);

/// The lines that a program should print of that run, in its order, and after each primitive's
/// lines those that are optional.
std::vector<RightLine> rightLinesOf(const TracedScene &run, const LineKinds &kinds,
                                    const Margin &margin);

} // namespace pixelplumb
