// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecoordinates.h"
#include "core/check/casepicture.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Reads the triangles of a hard case of the kind effects, each with "vertices", "colours",
/// "alpha", "z", "w", "uv" and "material", and how they look: "materials", "depth", "depthBits",
/// "antialiasing". All but vertices and colours is spelled as in scenes. The JsonReader keeps
/// errors.
void readEffectCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                    HardCase &hardCase);

/// Where the drawing falls short of the facts about the picture.
QStringList effectShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing);

/// Why the method cannot draw effects under these settings; empty where it can.
QString effectRefusal(const ScanSettings &settings, const Method &method);

} // namespace pixelplumb
