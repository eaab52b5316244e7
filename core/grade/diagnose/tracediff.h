// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"
#include "core/grade/try/writtentrace.h"
#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

/// Whether the trace is complete. A program that ended badly leaves out lines, and it is unknown
/// which.
enum class TraceExtent { Whole, CutOff };

/// The first quantity in which a program's trace differs from the right one.
struct TraceDifference {
    QString
        text; ///< "column 12, y_T: 41.5, should be 41 4/7"; with several triangles also the number
    Scene scene; ///< the right run: exact, by the method that has these numbers
    std::size_t step = 0; ///< in its trace

    friend bool operator==(const TraceDifference &, const TraceDifference &) = default;
};

/// Compares what a program printed with the exact run, line by line in the program's order. Kinds
/// of lines that it never prints are not required, nor are columns and rows without a pixel. A
/// pixel's whole numbers are compared with its bytes, others with its levels before rounding.
/// Reported are numbers, lines that are missing, repeated or at no pixel of the triangles,
/// triangles that are named but do not exist, and finally the order of columns or rows, from either
/// end. Lines outside the trace's frame are skipped. None where nothing differs; an error where no
/// method with those lines draws the scene. A cut-off trace lacks nothing.
///
/// A number is right if it is the right one rounded to the digits printed: within half a unit of
/// the last digit. Beyond that it may differ by ArithmeticBound's error of a right program in the
/// margin's tolerance; a pixel that the margin leaves undecided is optional. Strict: only the
/// rounding of the printed digits. Once: a sample that triangles share comes once.
Result<std::optional<TraceDifference>> traceDifferenceOf(const Scene &scene,
                                                         const ProgramTrace &trace,
                                                         const Margin &margin = {},
                                                         TraceExtent extent = TraceExtent::Whole);

} // namespace pixelplumb
