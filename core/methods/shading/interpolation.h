// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// Colour, depth, texture coordinates and normals over a triangle, in the three forms of the Scan
/// Conversion slides, "Interpolation During Scan Conversion". The picture shows the colour; a trace
/// also carries the triangles' other attributes.
Method bilinearInterpolationMethod();
Method bilinearRowsInterpolationMethod();
Method planeInterpolationMethod();
Method barycentricInterpolationMethod();

} // namespace pixelplumb
