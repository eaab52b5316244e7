// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/grade/pictures/picturediff.h"

#include <QStringList>

namespace pixelplumb {

/// Where a picture's wrong pixels lie, a sentence for each kind of them: "12 pixels are missing:
/// all at the right ends of their rows". Undecidable ones are left out. Coordinates are the
/// frame's, px. What is said of most holds for at least nine tenths of them.
QStringList wrongPlaces(const PictureDiff &diff, const Picture &expected, const FrameSpec &frame);

} // namespace pixelplumb
