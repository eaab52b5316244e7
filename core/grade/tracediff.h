// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/writtentrace.h"
#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

/// Of a program that came to no good end lines are left out, and nobody knows which.
enum class TraceExtent { Whole, CutOff };

/// The first quantity in which a program's trace differs from the right one.
struct TraceDifference {
    QString
        text; ///< "column 12, y_T: 41.5, should be 41 4/7"; of several triangles with its number
    Scene scene; ///< the run that is right: exact, by the method that has these numbers
    std::size_t step = 0; ///< of its trace

    friend bool operator==(const TraceDifference &, const TraceDifference &) = default;
};

/// Compares what a program printed with the exact run, line by line in the program's order; kinds
/// of lines that it prints none of are not asked for, nor are columns and rows without a pixel. A
/// pixel's whole numbers are compared with its bytes, others with its levels before rounding. Told
/// are numbers, lines that are missing, doubled or of no pixel of the triangles, triangles that are
/// named and not there, and at last the order of columns or rows, from whichever end. Lines beyond
/// the frame, which the trace is to be of, are passed over. None where nothing differs; an error
/// where no method of those lines draws the scene. Of a trace that is cut off nothing is missing.
///
/// A number is right that is the right one rounded to the digits printed: half a unit of the last
/// one. Beyond that it may err by what ArithmeticBound says of a right program in the tolerance,
/// float32 or float64; a pixel of which that is not sure may be there or not. Exact: the digits
/// printed alone.
Result<std::optional<TraceDifference>> traceDifferenceOf(const Scene &scene,
                                                         const ProgramTrace &trace,
                                                         Arithmetic tolerance = Arithmetic::Float32,
                                                         TraceExtent extent = TraceExtent::Whole);

} // namespace pixelplumb
