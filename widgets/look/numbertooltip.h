// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/scansettings.h"
#include "core/trace/numberdescription.h"

namespace pixelplumb {

/// A title or formula without the signs that set subscripts: "yB".
QString withoutMarkup(QString symbols);

/// What a number is and where it comes from.
QString numberToolTip(const NumberDescription &number);
/// The same with its value in hand, and the exact one where there is one to compare.
QString numberToolTip(const NumberDescription &number, const Quantity &used, const Quantity &exact,
                      Arithmetic arithmetic);

} // namespace pixelplumb
