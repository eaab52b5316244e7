// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "tests/support/framespec.h"

#include <QString>

/// Random triangles with effects, the same from the same seed on every machine.
namespace pixelplumb {

/// What is hard about a scene.
enum class EffectHardship {
    None, ///< anywhere in the frame and beside it
    WholePixels, ///< vertices on samples, so that edges pass through others
    Slivers, ///< a few lattice units thick
    SharedEdges, ///< a fan around a point
    Coincident, ///< the same place, depths equal or a last bit apart
    Crossing, ///< depths that cross, at whole pixels exactly
    Horizon, ///< w from 2^-20 to 2^10 in one triangle
    TexelBorders, ///< u and v multiples of 1/8 at samples
    FarAway, ///< at 2^20 px
    Segments, ///< triangles without area among others: lines, upright ones, points
};
inline constexpr std::array allEffectHardships
    = {EffectHardship::None,        EffectHardship::WholePixels,  EffectHardship::Slivers,
       EffectHardship::SharedEdges, EffectHardship::Coincident,   EffectHardship::Crossing,
       EffectHardship::Horizon,     EffectHardship::TexelBorders, EffectHardship::FarAway,
       EffectHardship::Segments};
QString nameOf(EffectHardship hardship);

struct EffectScene {
    QString name; ///< "slivers: perspective, texture, 4 samples"
    FrameSpec frame;
    Primitives primitives; ///< sample coordinates
};

/// Which effects there are is random too. But for Segments, every triangle has an area.
EffectScene randomEffectScene(std::uint64_t seed, EffectHardship hardship);

} // namespace pixelplumb
