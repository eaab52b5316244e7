// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"

#include <QRgb>

#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

/// What a plain kernel is measured by: the same arithmetic under the closed rule, rounded to
/// nearest, as one function that writes through a raw pointer, without clipping, rules, traces or
/// observers. Its pictures are the plain kernel's, bit for bit, where the triangles lie inside the
/// frame and have area.
namespace pixelplumb {

/// A frame as an address and two steps: of a column walk u is x and v is y, of a row walk u is −y
/// and v is x.
struct RawFrame {
    QRgb *origin = nullptr; ///< the pixel (0, 0)
    std::ptrdiff_t perU = 0, perV = 0; ///< pixels

    QRgb *at(std::ptrdiff_t u, std::ptrdiff_t v) const { return origin + u * perU + v * perV; }
};

/// A row of the table of straight loops.
struct StraightLoop {
    const char *method; ///< the plain kernel that draws the same picture
    Arithmetic arithmetic;
    bool isRowWalk = false; ///< gets the triangle and the frame turned by a quarter
    void (*draw)(const Triangle &triangle, RawFrame frame) = nullptr;
};

/// One after the other, they are the whole table.
std::span<const StraightLoop> straightColumns();
std::span<const StraightLoop> straightExactColumns();
std::span<const StraightLoop> straightSamples();
std::span<const StraightLoop> straightExactSamples();
std::span<const StraightLoop> straightInterpolations();

/// All of them.
std::vector<StraightLoop> straightLoops();
/// Null where the kernel has none.
const StraightLoop *straightLoopOf(std::string_view method, Arithmetic arithmetic);

/// The triangle as the loop wants it: turned by a quarter for a row walk.
Triangle triangleFor(const StraightLoop &loop, const Triangle &triangle);
/// The frame as the loop wants it; pixel (0, 0) must lie in the frame.
RawFrame rawFrameFor(const StraightLoop &loop, const FrameView &frame);

// Whole numbers of a float, for values that fit.

template <std::floating_point Float>
std::int64_t straightFloor(Float v)
{
    const auto towardsZero = std::int64_t(v);
    return towardsZero - std::int64_t(Float(towardsZero) > v);
}

template <std::floating_point Float>
std::int64_t straightCeil(Float v)
{
    const auto towardsZero = std::int64_t(v);
    return towardsZero + std::int64_t(Float(towardsZero) < v);
}

// A level as a byte, as briefly as it can be said in each number. NaN is 0.

template <std::floating_point Float>
int byteOf(Float level)
{
    level += Float(0.5);
    level = level > Float(0) ? level : Float(0);
    return int(level < Float(255) ? level : Float(255));
}

} // namespace pixelplumb
