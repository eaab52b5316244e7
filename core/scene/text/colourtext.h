// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"
#include "core/scene/text/result.h"

#include <QStringView>

namespace pixelplumb {

/// A colour and its opacity: 0 transparent … 255 opaque.
struct BlendedColour {
    Colour colour;
    std::uint8_t alpha = 255;

    friend bool operator==(const BlendedColour &, const BlendedColour &) = default;
};

/// Reads "#rrggbb" and "#rrggbbaa".
Result<BlendedColour> parseColour(QStringView text);

/// "#rrggbb"
QString colourText(const Colour &colour);
/// "#rrggbbaa", or "#rrggbb" for an opaque colour.
QString colourText(const BlendedColour &colour);

} // namespace pixelplumb
