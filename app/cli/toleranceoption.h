// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/scan/scansettings.h"

namespace pixelplumb::cli {

/// Adds --tolerance: the arithmetic in which a right program may compute.
void addToleranceOption(CommandLine &line);
/// Float32, float64 or exact.
Result<Arithmetic> chosenTolerance(const CommandLine &line);

} // namespace pixelplumb::cli
