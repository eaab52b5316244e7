// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/contender.h"
#include "core/scene/result.h"

namespace pixelplumb::cli {

/// Reads "method[:arithmetic[:fill-rule[:variant…]]]" or "truth[:fill-rule]". What is left out
/// comes from the scene, or is the method's first choice where it lacks the scene's. The error
/// names the place ("--methods") and the wrong word.
Result<Contender> contenderNamed(const QString &place, const QString &entry,
                                 const ScanSettings &ofScene);

/// Reads two to four contenders, separated by commas, from the option --methods.
Result<std::vector<Contender>> contendersNamed(const QString &list, const ScanSettings &ofScene);

} // namespace pixelplumb::cli
