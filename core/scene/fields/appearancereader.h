// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/scene/fields/referredfiles.h"

namespace pixelplumb {

/// The keys of a scene that say how its triangles look: "materials", "lights", "ambient",
/// "shading", "depth", "depthBits", "antialiasing".
QStringList appearanceKeys();

/// Reads these keys; a missing one keeps Appearance's default. Errors stay with the JsonReader.
Appearance readAppearance(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                          const JsonNode &root);

} // namespace pixelplumb
