// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/labcontender.h"

#include <QPalette>
#include <qcustomplot.h>

namespace pixelplumb {

/// The dot of an arithmetic in the charts of the lab; each shape belongs to one arithmetic. A SIMD
/// kernel, which draws several pixels at once, has the dot twice, side by side.
QCPScatterStyle kernelDot(Arithmetic arithmetic, LabKernel kernel, const QPalette &palette);
/// The hollow dot of an arithmetic's straight loop.
QCPScatterStyle straightLoopDot(Arithmetic arithmetic, const QPalette &palette);
/// The dot, faint: there is no time yet.
QCPScatterStyle waitingDot(QCPScatterStyle dot);

} // namespace pixelplumb
