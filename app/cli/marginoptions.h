// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/grade/margin.h"

namespace pixelplumb::cli {

/// Adds --tolerance: the arithmetic in which a right program may compute.
void addToleranceOption(CommandLine &line);
Result<Arithmetic> chosenTolerance(const CommandLine &line);
/// Adds --leeway, too: what a right program may draw otherwise.
void addMarginOptions(CommandLine &line);
Result<Margin> chosenMargin(const CommandLine &line);

} // namespace pixelplumb::cli
