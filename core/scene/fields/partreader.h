// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/scene/fields/referredfiles.h"

#include <QStringList>

namespace pixelplumb {

/// Reads the keys of a scene that say how its triangles look: "materials", "lights", …; a missing
/// one has its default. Errors stay with the JsonReader.
Appearance readAppearance(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                          const JsonNode &root);

/// The keys of a scene before its primitives, those of its appearance last.
QStringList surroundingKeys();

/// Reads these keys of the root, a scene.
void readSurroundings(JsonReader &json, NumberReader &numbers, ReferredFiles &files, Scene &scene);

} // namespace pixelplumb
