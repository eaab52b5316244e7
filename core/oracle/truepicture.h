// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/oracle/strokeoracle.h"
#include "core/shade/effectplan.h"

namespace pixelplumb::oracle {

/// Draws the true picture of all primitives, in opaque pixels as oracle::draw does: the triangles
/// with their effects where a plan shades them (else null), then the shapes, with lines and curves
/// antialiased where the appearance asks for it, else as `strokes` says. The frame may be a band of
/// the one that was planned for.
void drawPicture(const Primitives &primitives, const ScanSettings &settings,
                 const EffectPlan *shading, FrameView frame,
                 StrokeTruth strokes = StrokeTruth::NearestPixels);

} // namespace pixelplumb::oracle
