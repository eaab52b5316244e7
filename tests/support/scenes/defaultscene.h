// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

/// The scene that the panel tests use.
namespace pixelplumb {

inline Vertex vertexAt(double x, double y, const Colour &colour)
{
    return {{Lattice(x * unitsPerPixel), Lattice(y * unitsPerPixel)}, colour};
}

/// The default scene's triangle, repeated `triangles` times: columns 4 … 58, x₁ = 26 1/2.
inline Scene defaultSceneIn(Arithmetic arithmetic, int triangles = 1)
{
    Scene scene;
    scene.settings.arithmetic = arithmetic;
    scene.triangles.assign(std::size_t(triangles),
                           {{vertexAt(4, 5, {{255, 0, 0}}), vertexAt(58, 12, {{0, 255, 0}}),
                             vertexAt(26.5, 44, {{0, 0, 255}})}});
    return scene;
}

/// The table row of column x in a scene with one such triangle.
constexpr int rowOf(int x) { return x - 4; }

} // namespace pixelplumb
