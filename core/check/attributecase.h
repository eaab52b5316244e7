// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecoordinates.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Reads "attributes" of a hard case of the kind attributes: z, u, v and the normal at the three
/// vertices, integers in units of 1/256; errors stay with the JsonReader.
void readAttributes(JsonReader &json, const JsonNode &node, HardCase &hardCase);

/// Reads "values" of a point: by the titles of an interpolation's sample columns ("z", "N_x"), as
/// fractions, "85/42". None where the point has none.
std::map<QString, Quantity> readExpectedValues(JsonReader &json, const JsonNode &node);

/// What of the values at the case's points differs from the cells that the method records there
/// in exact arithmetic, under the rules whose y points up. Nothing in other arithmetics and of
/// methods that have no such cells: these answer for the picture alone.
QStringList valueShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                            const Method &method);

} // namespace pixelplumb
