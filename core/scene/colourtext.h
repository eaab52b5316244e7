// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"
#include "core/scene/result.h"

#include <QStringView>

namespace pixelplumb {

/// Reads "#rrggbb", and "#rrggbbaa" where aa is ff: colours are opaque as long as nothing blends
/// them.
Result<Colour> parseColour(QStringView text);

/// "#rrggbb"
QString colourText(const Colour &colour);

} // namespace pixelplumb
