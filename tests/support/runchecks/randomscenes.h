// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenes/scenesformethods.h"

namespace pixelplumb {

/// Scenes with primitives of every kind, the same on every machine; a method draws the kinds it
/// knows. Any four in a row combine both origins with both pixel centres.
std::vector<NamedScene> randomScenes(int count);

} // namespace pixelplumb
