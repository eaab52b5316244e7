// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"

namespace pixelplumb::cli {

/// Adds --seed, 1 by default; `what` is drawn at random: "scenes".
void addSeedOption(CommandLine &line, const QString &what);
Result<std::uint64_t> chosenSeed(const CommandLine &line);

} // namespace pixelplumb::cli
