// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"

namespace pixelplumb::cli {

/// --seed, 1 if it is left out; `what` is drawn by lot: "scenes".
void addSeedOption(CommandLine &line, const QString &what);
Result<std::uint64_t> chosenSeed(const CommandLine &line);
bool isSeedSet(const CommandLine &line);

} // namespace pixelplumb::cli
