// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/space/camera.h"

namespace pixelplumb {

/// Reads a scene's camera; a missing key keeps Camera's default. Errors stay with the JsonReader.
Camera readCamera(JsonReader &json, NumberReader &numbers, const JsonNode &node);

} // namespace pixelplumb
