// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/contender.h"
#include "core/scene/result.h"

namespace pixelplumb::cli {

/// Reads "method[:arithmetic[:fill-rule[:variant…]]]" or "truth[:fill-rule]"; what is left out is
/// the scene's, or the method's first where it does not have the scene's. The error names the place
/// ("--methods") and the word that is wrong.
Result<Contender> contenderNamed(const QString &place, const QString &entry,
                                 const ScanSettings &ofScene);

/// Two to four of them, separated by commas, of the option --methods.
Result<std::vector<Contender>> contendersNamed(const QString &list, const ScanSettings &ofScene);

} // namespace pixelplumb::cli
