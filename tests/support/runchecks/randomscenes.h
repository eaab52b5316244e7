// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenesformethods.h"

namespace pixelplumb {

/// Scenes with something of every kind, of which a method draws what it draws, the same on every
/// machine. Four that follow each other have every origin with every pixel centre.
std::vector<NamedScene> randomScenes(int count);

} // namespace pixelplumb
