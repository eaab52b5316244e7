// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"

/// What the points of a face's light are described by, as used and without rounding.
namespace pixelplumb {

/// What all points share: the viewer, the lights, and what the material does with them.
void writeLights(StagePoint &point, const Appearance &appearance, const Material &material);

/// The light at a vertex or at a face's centre: n, L, V and H of length 1, the terms of each light,
/// the levels and their bytes. Its place and its normal are given before.
void writeLightAt(StagePoint &point, const Appearance &appearance, const Material &material,
                  const LitColour<double> &used, const LitColour<ExactReal> &exact);

} // namespace pixelplumb
