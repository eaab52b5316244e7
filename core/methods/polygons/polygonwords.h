// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/polygons/polygonstate.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// What the scan of a whole polygon says: by which test its fill decides; for a row and a sample,
/// which crossings count, how many there are, and what follows from their number.
void tellPolygon(StepWords &words, const PolygonSetUp &setUp);
void tellPolygon(StepWords &words, const PolygonRowState &row);
void tellPolygon(StepWords &words, const PolygonSampleState &sample);

} // namespace pixelplumb
