// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/labcontender.h"

#include <QPalette>
#include <qcustomplot.h>

namespace pixelplumb {

/// The dot of an arithmetic in the charts of the lab: each shape is one arithmetic's alone. That of
/// a SIMD kernel, which draws several pixels at once, stands twice, side by side.
QCPScatterStyle kernelDot(Arithmetic arithmetic, LabKernel kernel, const QPalette &palette);
/// The hollow dot of its straight loop.
QCPScatterStyle straightLoopDot(Arithmetic arithmetic, const QPalette &palette);
/// A cross, where the column scan in this arithmetic has the dot; another one for the next method.
QCPScatterStyle otherMethodDot(Arithmetic arithmetic, std::size_t method, const QPalette &palette);
/// The same, faint: there is no time yet.
QCPScatterStyle waitingDot(QCPScatterStyle dot);

} // namespace pixelplumb
