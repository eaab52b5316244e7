// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "core/scan/errorlimit.h"

namespace pixelplumb {

/// How far the bounds of one span are from the exact edges, px; positive means too high or too far
/// right.
struct BoundError {
    SpanPlace place;
    double lower = 0;
    double upper = 0;
    /// The most that rounding can have added up to here (see errorLimit), px.
    double limit = 0;
    /// The span begins, or ends, at another sample than in exact numbers; both are set if one of
    /// the two spans covers no sample.
    bool isLowerWrong = false, isUpperWrong = false;
};

/// The errors of one primitive's spans in one arithmetic, in the order of the run.
struct BoundErrors {
    Arithmetic arithmetic = Arithmetic::Float32;
    std::vector<BoundError> spans;
};

/// The errors in every rounding arithmetic that the scene's method has, for a triangle of the
/// scene. Empty where the method's spans have no bounds. The listener is called for every span;
/// none if it ended the job.
std::optional<std::vector<BoundErrors>> boundErrorsOf(const Scene &scene, std::size_t triangle,
                                                      const ProgressListener &listener = {});

} // namespace pixelplumb
