// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"

namespace pixelplumb {

/// Where a drawing falls short of the facts of a case made of triangles: for one triangle, by its
/// picture; for a mesh, by how often each pixel is covered; for a sequence of frames, by the pixels
/// that come and go; for a triangle moved by whole pixels, by the pictures that differ.
QStringList triangleShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                               const Drawing &drawing);

} // namespace pixelplumb
