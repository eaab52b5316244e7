// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "tests/support/framespec.h"

#include <QString>

/// Random triangles with effects; a seed gives the same scene on every machine.
namespace pixelplumb {

/// What is hard about a scene.
enum class EffectHardship {
    None, ///< anywhere in and around the frame
    WholePixels, ///< vertices on samples, so that edges pass through other samples
    Slivers, ///< a few lattice units thick
    SharedEdges, ///< a fan around a point
    Coincident, ///< in the same place, depths equal or one last bit apart
    Crossing, ///< depths that cross exactly at whole pixels
    Horizon, ///< w from 2^-20 to 2^10 in one triangle
    TexelBorders, ///< u and v are multiples of 1/8 at samples
    FarAway, ///< at 2^20 px
    Segments, ///< segments among the triangles (no area): sloping or vertical ones, and points
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
    Primitives primitives; ///< in sample coordinates
};

/// Which effects the scene has is random too. Except for Segments, every triangle has an area.
EffectScene randomEffectScene(std::uint64_t seed, EffectHardship hardship);

} // namespace pixelplumb
