// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace pixelplumb {

/// The signs of a tape deck. Drawn, not taken from a font: no font can be relied on to have them.
enum class StepSign { ToStart, Backward, Play, Pause, Forward, ToEnd };

/// In the palette's text colour of the moment, also when disabled, at any size.
QIcon stepIcon(StepSign sign);

} // namespace pixelplumb
