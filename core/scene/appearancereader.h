// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/numberreader.h"
#include "core/scene/referredfiles.h"

namespace pixelplumb {

/// "materials", "lights", "ambient", "shading", "depth", "depthBits", "antialiasing": the keys of a
/// scene that say how its triangles look.
QStringList appearanceKeys();

/// Reads them, what is left out as Appearance has it; errors stay with the JsonReader.
Appearance readAppearance(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                          const JsonNode &root);

} // namespace pixelplumb
