// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"
#include "core/scan/edgetestbugs.h"

namespace pixelplumb {

/// A program that tests three edges at the samples of the bounding box, with its bugs. What they do
/// not change, colours included, is drawn as by the method.
Redrawing redrawingByTests(const EdgeTestBugs &bugs);

} // namespace pixelplumb
