// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/scene/fields/numberreader.h"

namespace pixelplumb {

/// The keys of what a triangle may carry besides positions and colours: "z": [z, z, z], "w": [w, w,
/// w], "uv": [[u, v], …], "normals": [[x, y, z], …], "material": "name".
QStringList attributeKeys();

/// Reads these keys; a missing one has its default. Errors stay with the JsonReader.
TriangleAttributes readAttributes(JsonReader &json, NumberReader &numbers, const JsonNode &triangle,
                                  const std::vector<Material> &materials);

/// The index of the material that the node names; none where the node is missing.
int readMaterialName(JsonReader &json, const JsonNode &node,
                     const std::vector<Material> &materials);

/// ", \"z\": […], \"uv\": […], …": what readAttributes() reads back, without defaults.
QByteArray attributesText(const TriangleAttributes &attributes,
                          const std::vector<Material> &materials);

/// ", \"material\": \"name\"", or nothing.
QByteArray materialText(int material, const std::vector<Material> &materials);

} // namespace pixelplumb
