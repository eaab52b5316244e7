// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/colourtext.h"
#include "core/scene/text/jsonreader.h"

namespace pixelplumb {

/// Reads a colour "#rrggbb"; errors stay with the JsonReader.
Colour readColour(JsonReader &json, const JsonNode &node);
/// Reads a colour "#rrggbb" or "#rrggbbaa".
BlendedColour readBlendedColour(JsonReader &json, const JsonNode &node);

} // namespace pixelplumb
