// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace pixelplumb {

/// The signs of a tape deck. They are drawn, because no font can be relied on to have them.
enum class StepSign { ToStart, Backward, Play, Pause, Forward, ToEnd };

/// An icon in the palette's current text colour, also when disabled, at any size.
QIcon stepIcon(StepSign sign);

} // namespace pixelplumb
