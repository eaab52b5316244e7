// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/wideinteger.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pixelplumb {

/// One coordinate of a piece's control points, or a sum or difference of both.
using BezierControls = std::array<BigInteger, 4>;

/// The control points of a piece of a Bézier curve in units of 1/(256·2^(degree·depth)) px: each
/// cut is exact.
struct BezierPiece {
    BezierControls x = {};
    BezierControls y = {};
    std::size_t count = 3; ///< control points: 3 or 4
    int depth = 0; ///< cuts that led here
    BigInteger part = 0; ///< the piece runs from t = part/2^depth to (part + 1)/2^depth

    int degree() const { return int(count) - 1; }
    /// 1 px in the units of the control points.
    BigInteger pixel() const { return BigInteger(unitsPerPixel) << (degree() * depth); }
    bool isFirst() const { return part == 0; }
    bool isLast() const { return part + 1 == BigInteger(1) << depth; }
};

/// The two halves of one coordinate's control points, both scaled by 2^degree.
inline void halve(const BezierControls &whole, std::size_t count, BezierControls &left,
                  BezierControls &right)
{
    BezierControls sums = whole; // sums[i]: of level + 1 neighbours, binomially weighted
    for (std::size_t level = 0; level < count; ++level) {
        left[level] = sums[0] << (count - 1 - level);
        right[count - 1 - level] = sums[count - 1 - level] << (count - 1 - level);
        for (std::size_t i = 0; i + level + 1 < count; ++i)
            sums[i] += sums[i + 1];
    }
}

/// De Casteljau's cut in the middle.
inline std::array<BezierPiece, 2> halvesOf(const BezierPiece &piece)
{
    std::array<BezierPiece, 2> halves = {piece, piece};
    for (std::size_t half = 0; half < 2; ++half) {
        halves[half].depth = piece.depth + 1;
        halves[half].part = 2 * piece.part + half;
    }
    halve(piece.x, piece.count, halves[0].x, halves[1].x);
    halve(piece.y, piece.count, halves[0].y, halves[1].y);
    return halves;
}

} // namespace pixelplumb
