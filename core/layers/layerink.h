// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"

#include <QColor>

namespace pixelplumb {

/// Whether layers are painted on light paper or on dark.
enum class LayerTone { Light, Dark };

/// From the Okabe–Ito set, like the window's signs, so that text in it keeps 4.5:1 on the paper.
QColor colourOf(LayerInk ink, LayerTone tone);
/// The background of lines and texts, which stay readable on every colour that a frame may hold.
QColor paperOf(LayerTone tone);

} // namespace pixelplumb
