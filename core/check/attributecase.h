// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecoordinates.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Reads "attributes" of a hard case of the kind attributes: z, u, v and the normal at the three
/// vertices, integers in units of 1/256; the JsonReader keeps errors.
void readAttributes(JsonReader &json, const JsonNode &node, HardCase &hardCase);

/// Reads the "values" of a point: by the titles of an interpolation's sample columns ("z", "N_x"),
/// as fractions, "85/42". Empty where the point has none.
std::map<QString, Quantity> readExpectedValues(JsonReader &json, const JsonNode &node);

/// Where the values at the case's points differ from the cells that the method records there in
/// exact arithmetic, under the rules whose y points up. Empty for other arithmetics and for methods
/// without such cells: those are judged by the picture alone.
QStringList valueShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                            const Method &method);

} // namespace pixelplumb
