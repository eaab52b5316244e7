// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/scene/jsonreader.h"

#include <functional>
#include <optional>

namespace pixelplumb {

/// The keys of what a triangle's vertices may carry beside their colours: "z": [z, z, z],
/// "uv": [[u, v], …], "normals": [[x, y, z], …].
QStringList attributeKeys();

/// Reads them; none where the triangle has none of the keys. Numbers are read as coordinates are.
std::optional<std::array<VertexAttributes, 3>> readAttributes(
    JsonReader &json, const JsonNode &triangle,
    const std::function<Lattice(const JsonNode &)> &number);

/// ", \"z\": […], \"uv\": […], \"normals\": […]": what readAttributes reads back, without the keys
/// of which all numbers are 0.
QByteArray attributesText(const std::array<VertexAttributes, 3> &vertices);

} // namespace pixelplumb
