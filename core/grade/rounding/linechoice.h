// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/arithmeticbound.h"
#include "core/scene/scene.h"

#include <array>
#include <vector>

namespace pixelplumb {

/// A step of a line: right programs draw one of these pixels there. There are several where the
/// line passes halfway between two of them, or nearer to that than a right program errs; of these
/// each is as right as the others.
struct LineChoice {
    std::vector<LatticePoint> pixels; ///< px; the nearest first
    std::array<LevelRange, 3> levels; ///< by channel, with the error of a right program

    bool mayHave(const Colour &colour, ByteRounding rounding) const;
};

/// The levels at a share of the way between two vertices, without an error.
std::array<double, 3> levelsBetween(const Vertex &from, const Vertex &to, double share);

/// Whether a scene consists of lines only and needs only colours.
bool isOfLines(const Scene &scene);

/// Whether a scene consists of lines only, each step of which draws the nearest pixel.
bool drawsNearestPixels(const Scene &scene);

/// The steps of such a scene's line, in sample coordinates, that may reach the frame. Arithmetic:
/// float32 or float64, with the bound of resources/numerics.md, 3.10; exact: only halves are open.
std::vector<LineChoice> lineChoices(const Shape &line, const Scene &scene, Arithmetic arithmetic);

} // namespace pixelplumb
