// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracedscene.h"

namespace pixelplumb {

/// How far the bounds of one span are from the exact edges, px; positive is too high or too far
/// right.
struct BoundError {
    SpanPlace place;
    double lower = 0;
    double upper = 0;
    /// What rounding may add up to until here (see errorLimit), px.
    double limit = 0;
    bool isWrong = false; ///< the span covers other samples than it does in exact numbers
};

/// The errors of one primitive's spans in one arithmetic, in the order of the run.
struct BoundErrors {
    Arithmetic arithmetic = Arithmetic::Float32;
    std::vector<BoundError> spans;
    std::optional<std::size_t> firstWrong; ///< index of the first span that is wrong
    std::size_t wrongCount = 0;
};

/// Those of every rounding arithmetic that the scene's method has, for a triangle of the scene.
/// Empty where the method's spans have no bounds. `goesOn` is asked at every span; none when it
/// says no.
std::optional<std::vector<BoundErrors>> boundErrorsOf(const Scene &scene, std::size_t triangle,
                                                      const std::function<bool()> &goesOn = {});

/// The largest error that n additions make by rounding, px: n·ulp(largest)/2 in floating point,
/// n·2⁻¹⁷ in 16.16 and n·2⁻³³ in 32.32, for a number of that magnitude (numerics.md, 2.2 and 3.4).
double errorLimit(Arithmetic arithmetic, double additions, double largest);

} // namespace pixelplumb
