// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"

namespace pixelplumb {

/// What falls short of the facts of a case that consists of triangles: of one, by its picture; of a
/// mesh, by how often each pixel is covered; of a sequence of frames, by the pixels that come and
/// go; of a triangle that is moved by whole pixels, by the pictures that differ.
QStringList triangleShortfalls(const HardCase &hardCase, const ScanSettings &settings,
                               const Drawing &drawing);

} // namespace pixelplumb
