// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/geometry/effect.h"

namespace pixelplumb::cli {

/// Adds --force EFFECT=on|off, which may be repeated.
void addForceOption(CommandLine &line);

/// What the options switch by hand, or the error in one of them.
Result<EffectForcing> chosenForcing(const CommandLine &line);

} // namespace pixelplumb::cli
