// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <QPalette>
#include <qcustomplot.h>

namespace pixelplumb {

enum class DotFill { Solid, Hollow };

/// The dot of an arithmetic in the charts of the lab: each shape is one arithmetic's alone.
QCPScatterStyle arithmeticDot(Arithmetic arithmetic, DotFill fill, const QPalette &palette);

} // namespace pixelplumb
