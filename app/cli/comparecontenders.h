// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/contender.h"
#include "core/scene/result.h"

namespace pixelplumb::cli {

/// Reads "method[:arithmetic[:fill-rule]]" and "truth[:fill-rule]", separated by commas; what is
/// left out is the scene's, or the method's first where it does not have the scene's. The error
/// names the word that is wrong.
Result<std::vector<Contender>> contendersNamed(const QString &list, const ScanSettings &ofScene);

} // namespace pixelplumb::cli
