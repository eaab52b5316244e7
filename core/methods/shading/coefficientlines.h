// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/interpolation/interpolationnumbers.h"

#include <QStringList>

namespace pixelplumb {

/// The lines of a listing that work out what is linear in x and y over a triangle: each value
/// itself, or the weights α, β and γ. The operations are in the kernel's order, so that floats
/// agree. `values` names what is interpolated, such as "each carried value v".
QStringList coefficientLines(InterpolationForm form, const QString &values);

} // namespace pixelplumb
