// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"
#include "widgets/look/viewmapping.h"

#include <QPalette>

namespace pixelplumb {

/// Where layers are painted over a frame in a view.
LayerSurface layerSurface(const ViewMapping &mapping, const QRectF &view, const QPalette &palette);

/// A pixel's side, logical px.
double cellSideOf(const ViewMapping &mapping);

} // namespace pixelplumb
