// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

struct TracedScene;

/// What the message bar says of a run that is not what a person expects.
QString cutRunNote(const TracedScene &traced); ///< its recording ended at a limit
QString cancelledRunNote();

} // namespace pixelplumb
