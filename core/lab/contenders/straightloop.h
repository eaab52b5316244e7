// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"
#include "core/scan/spanaxis.h"

#include <QRgb>

#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

/// What a plain kernel is measured against: the same arithmetic, rounded to nearest, as one
/// function that writes through a raw pointer, without clipping, choices, traces or observers. For
/// triangles that it may draw, its pictures are the plain kernel's, bit for bit.
namespace pixelplumb {

/// A frame as an address and two steps: in a column walk u is x and v is y, in a row walk u is −y
/// and v is x.
struct RawFrame {
    QRgb *pixel = nullptr; ///< (firstU, firstV)
    std::ptrdiff_t firstU = 0, firstV = 0;
    std::ptrdiff_t perU = 0, perV = 0; ///< pixels

    QRgb *at(std::ptrdiff_t u, std::ptrdiff_t v) const
    {
        return pixel + (u - firstU) * perU + (v - firstV) * perV;
    }
};

/// Who owns a sample on the boundary.
enum class StraightRule {
    Closed, ///< the triangle's
    HalfOpen, ///< displaced by (+ε², +ε) in (u, v): ⌈v_B⌉ … ⌈v_T⌉−1, ⌈u₀⌉ … ⌈u₂⌉−1
};

using StraightDraw = void (*)(const Triangle &triangle, RawFrame frame);

/// A row of the table of straight loops.
struct StraightLoop {
    const char *method; ///< whose plain kernel draws the same picture
    Arithmetic arithmetic;
    SpanAxis axis; ///< rows: the triangle and the frame are turned by a quarter
    StraightDraw drawClosed, drawHalfOpen;

    /// The function that draws the kernel's picture under a rule; null if none does.
    StraightDraw drawUnder(FillRule rule, FrameOrigin origin) const;
};

/// Together, in this order, they are the whole table.
std::span<const StraightLoop> straightColumns();
std::span<const StraightLoop> straightSamples();
std::span<const StraightLoop> straightInterpolations();

/// All of them.
std::vector<StraightLoop> straightLoops();
/// Null if the kernel has none.
const StraightLoop *straightLoopOf(std::string_view method, Arithmetic arithmetic);

/// Whether nothing has to be clipped and no 64 bits overflow: the triangle has area, its box is
/// within 2^40 square lattice units, and it lies 2 px inside the frame and within 2^15 px. In 16.16
/// it must also lie on whole pixels, because slopes of steep sub-pixel edges wrap there.
bool mayDrawStraight(const StraightLoop &loop, const Triangle &triangle, const FrameView &frame);

/// The triangle as the loop needs it: turned by a quarter for a row walk.
Triangle triangleFor(const StraightLoop &loop, const Triangle &triangle);
/// The frame as the loop needs it.
RawFrame rawFrameFor(const StraightLoop &loop, const FrameView &frame);

/// A level as a byte; NaN is 0.
template <std::floating_point Float>
int byteOf(Float level)
{
    level += Float(0.5);
    level = level > Float(0) ? level : Float(0);
    return int(level < Float(255) ? level : Float(255));
}

/// ⌊sum / denominator + ½⌋ of each; sums inside a triangle are not negative.
inline QRgb straightPixelOf(const std::array<std::int64_t, 3> &sum, std::int64_t denominator)
{
    const auto nearest
        = [&](std::int64_t each) { return (2 * each + denominator) / (2 * denominator); };
    return pixelOfLevels({nearest(sum[0]), nearest(sum[1]), nearest(sum[2])});
}

} // namespace pixelplumb
