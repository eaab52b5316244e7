// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picturecause.h"

namespace pixelplumb {

/// Changes that put pixels in other places: flips, x and y exchanged, rows stored too far apart or
/// too close, columns stored in place of rows, shifts.
std::vector<PictureChange> placeChangesFor(const Picture &expected);

} // namespace pixelplumb
