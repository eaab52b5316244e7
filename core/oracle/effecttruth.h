// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb::oracle {

/// What of its appearance a true picture has. All that the scene says unless a person switched it
/// off: what the scene does not call for changes no pixel.
struct EffectTruth {
    bool smooth = true; ///< else the colour of the first vertex
    bool perspective = true; ///< else all attributes are linear in the frame
    bool texture = true;
    bool light = true;
    bool blending = true; ///< else as if every alpha were 255
    bool depth = true; ///< else in drawing order
    Antialiasing antialiasing = Antialiasing::None;
};

/// What the appearance says, and what was forced off.
EffectTruth truthOf(const Appearance &appearance);

/// Whether w differs between the vertices, and something that is divided by it and seen does too.
/// Only then has the triangle's plane a horizon: what is the same everywhere is so beyond it.
bool hasPerspective(const Primitives &primitives, std::size_t triangle, const EffectTruth &what);

/// Whether the triangle is lit at every sample.
bool isLit(const Primitives &primitives, std::size_t triangle, const EffectTruth &what);

/// Null where the triangle has none.
const Material *materialOf(const Primitives &primitives, std::size_t triangle);

/// Zeros, w = 1 and alpha = 255 where the triangle carries none.
const std::array<VertexAttributes, 3> &attributesOf(const Primitives &primitives,
                                                    std::size_t triangle);

} // namespace pixelplumb::oracle
