// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"
#include "core/scene/text/jsonreader.h"

namespace pixelplumb {

/// Reads "endpoints" (px, or in units of 1/scale px where the case has a "scale"), "rule" and
/// "expected" of a hard case of the kind line; the JsonReader keeps errors.
void readLineCase(JsonReader &json, const JsonNode &node, HardCase &hardCase);

/// Where a line, drawn from either end, falls short of the case's facts: count, hash and list of
/// pixels. The facts have no colours.
QStringList lineShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                           const Drawing &drawing);

} // namespace pixelplumb
