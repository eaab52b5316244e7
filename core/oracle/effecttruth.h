// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb::oracle {

/// Which effects a true picture has: all that the scene asks for, unless a person switched them
/// off. An effect that the scene does not call for changes no pixel.
struct EffectTruth {
    bool smooth = true; ///< else the first vertex's colour
    bool perspective = true; ///< else all attributes are linear in the frame
    bool texture = true;
    bool light = true;
    bool blending = true; ///< else as if every alpha were 255
    bool depth = true; ///< else drawing order decides
    Antialiasing antialiasing = Antialiasing::None;
};

/// The effects that the appearance asks for, without those forced off.
EffectTruth truthOf(const Appearance &appearance);

/// Whether w differs between the vertices along with something visible that is divided by it. Only
/// then does the triangle's plane have a horizon: what is constant stays the same beyond it.
bool hasPerspective(const Primitives &primitives, std::size_t triangle, const EffectTruth &what);

/// Whether the triangle is lit at every sample.
bool isLit(const Primitives &primitives, std::size_t triangle, const EffectTruth &what);

/// Null where the triangle has none.
const Material *materialOf(const Primitives &primitives, std::size_t triangle);

/// Zeros, w = 1 and alpha = 255 where the triangle carries none.
const std::array<VertexAttributes, 3> &attributesOf(const Primitives &primitives,
                                                    std::size_t triangle);

} // namespace pixelplumb::oracle
