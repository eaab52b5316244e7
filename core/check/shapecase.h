// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecoordinates.h"
#include "core/check/casepicture.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Reads "centre", "radius" and "fill" of a hard case of the kind circle; the JsonReader keeps
/// errors. "expected" is not read here.
void readCircleCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                    HardCase &hardCase);

/// Reads "polygons" and "fill" of the kind polygon: a list of polygons, each a list of contours,
/// each a list of three or more vertices. "expected" is not read here.
void readPolygonCase(JsonReader &json, const JsonNode &node, CaseCoordinates &coordinates,
                     HardCase &hardCase);

/// Where circles and polygons fall short of the facts: in the picture of all shapes together, and
/// in how often each pixel is covered by the shapes one by one.
QStringList shapeShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                            const Drawing &drawing);

/// Why the method refuses a shape of the case: not convex, or crossing itself; empty where it draws
/// them all.
QString shapeRefusal(const HardCase &hardCase, const ScanSettings &settings, const Method &method);

} // namespace pixelplumb
