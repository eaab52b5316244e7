// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/oracle/strokeoracle.h"

namespace pixelplumb {

/// Which picture of lines and curves is true for a method; for none, the truth itself, that of the
/// nearest pixels.
inline oracle::StrokeTruth strokeTruthOf(const Method *method)
{
    const bool isWide
        = method && method->draws(PrimitiveKind::Line) && method->supports(Effect::Antialiasing);
    return isWide ? oracle::StrokeTruth::PixelWide : oracle::StrokeTruth::NearestPixels;
}

} // namespace pixelplumb
