// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Whether the case's shapes are lines or curves that the method antialiases, one pixel wide: the
/// facts describe the thinnest pictures, so only the truth can tell what such a method should draw.
bool isStrokeCase(const HardCase &hardCase, const Method &method);

/// Where the shapes' antialiased pictures, by area and by 4 and 16 samples, differ from the truth,
/// around the shapes' ends, middles and extremes.
QStringList strokeShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                             const Drawing &drawing);

} // namespace pixelplumb
