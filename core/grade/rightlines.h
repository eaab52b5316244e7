// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/tracediff.h"
#include "core/runs/tracedscene.h"

#include <memory>
#include <tuple>
#include <vector>

namespace pixelplumb {

/// Of which kind a line is (none: a pixel), and its x and y.
using Place = std::tuple<std::optional<SpanAxis>, std::int64_t, std::int64_t>;

/// What a program should print of a step of ours.
struct RightLine {
    Place place;
    std::size_t primitive = 0;
    std::size_t step = 0;
    std::vector<Quantity> numbers;
    double drift = 0; ///< that is allowed of them; infinite where they may be anything
    bool isAskedFor = true; ///< false: it may be there or not
};

/// The scene as a run that is right and has numbers of these kinds: its own method where that has
/// them. Null where no method has.
std::shared_ptr<const TracedScene> rightRunOf(Scene scene, const LineKinds &kinds);

/// What a program should print of that run, in its order, and after a primitive's lines those that
/// it may have beside them; `tolerance`: see traceDifferenceOf().
std::vector<RightLine> rightLinesOf(const TracedScene &run, const LineKinds &kinds,
                                    Arithmetic tolerance);

} // namespace pixelplumb
