// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/scan/linebugs.h"

namespace pixelplumb {

/// The scene of lines as drawn by a program with these bugs. Lines that are not between samples
/// keep the steps of the scene's method.
Picture drawnBy(const LineBugs &bugs, const Scene &scene);

} // namespace pixelplumb
