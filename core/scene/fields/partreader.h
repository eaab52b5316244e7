// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/referredfiles.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/jsonreader.h"

namespace pixelplumb {

/// A scene while it is read; errors stay with the JsonReader.
struct CurrentScene {
    SceneReading reading;
    ReferredFiles files;
    std::size_t solidTriangles = 0; ///< that its solids are cut into so far
    /// Of its shapes so far; each character of a text counts as several.
    std::size_t shapeVertices = 0;
};

/// The keys of a scene before its primitives, those of its appearance last.
QStringList surroundingKeys();

/// Reads these keys of the root, a scene.
void readSurroundings(JsonReader &json, CurrentScene &current);

/// Reads the keys that say how triangles look: "materials", "lights", …; a missing one has its
/// default.
void readAppearance(JsonReader &json, CurrentScene &current, const JsonNode &root);

/// Reads what a triangle carries besides positions and colours: "z", "uv", …; a missing one has its
/// default.
TriangleAttributes readAttributes(JsonReader &json, CurrentScene &current,
                                  const JsonNode &triangle);

/// Appends the primitive to the scene's triangles, solids, shapes or hidden ones.
void readPrimitive(JsonReader &json, CurrentScene &current, const JsonNode &primitive);

} // namespace pixelplumb
