// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/scan/scansettings.h"
#include "core/trace/numberdescription.h"

namespace pixelplumb {

/// A title or formula without the markup of subscripts: "yB".
QString withoutMarkup(QString symbols);

/// The tool tip of a number: what it is and where it comes from.
QString numberToolTip(const NumberDescription &number);
/// The tool tip with the number's current value, and the exact one where there is one to compare.
QString numberToolTip(const NumberDescription &number, const Quantity &used, const Quantity &exact,
                      Arithmetic arithmetic);

} // namespace pixelplumb
