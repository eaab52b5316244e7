// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/straightloop.h"

#include "core/scan/biasarithmetic.h"
#include "core/scan/rowwalk.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const std::vector<StraightLoop> &table()
{
    static const std::vector<StraightLoop> loops = straightLoops();
    return loops;
}

} // namespace

std::vector<StraightLoop> straightLoops()
{
    std::vector<StraightLoop> loops;
    for (const auto part : {straightColumns(), straightSamples(), straightInterpolations()})
        loops.insert(loops.end(), part.begin(), part.end());
    return loops;
}

const StraightLoop *straightLoopOf(std::string_view method, Arithmetic arithmetic)
{
    const auto found = std::ranges::find_if(table(), [&](const StraightLoop &loop) {
        return loop.method == method && loop.arithmetic == arithmetic;
    });
    return found == table().end() ? nullptr : &*found;
}

bool mayDrawStraight(const StraightLoop &loop, const Triangle &triangle, const FrameView &frame)
{
    constexpr Lattice margin = 2 * unitsPerPixel;
    const LatticePoint first = latticePixel(frame.firstColumn, frame.firstRow);
    const LatticePoint last = latticePixel(frame.endColumn() - 1, frame.endRow() - 1);
    const auto isInside = [&](const Vertex &vertex) {
        const auto [x, y] = vertex.position;
        return x >= first.x + margin && x <= last.x - margin && y >= first.y + margin
            && y <= last.y - margin;
    };
    const auto isOnPixel = [](const Vertex &vertex) {
        return vertex.position.x % unitsPerPixel == 0 && vertex.position.y % unitsPerPixel == 0;
    };
    return doubledArea(triangle) != 0 && integerWidthFor(triangle) == IntegerWidth::Bits64
        && biasdomain::containsPlane(triangle) && std::ranges::all_of(triangle.vertices, isInside)
        && (loop.arithmetic != Arithmetic::Fixed16
            || std::ranges::all_of(triangle.vertices, isOnPixel));
}

StraightDraw StraightLoop::drawUnder(FillRule rule, FrameOrigin origin) const
{
    if (rule == FillRule::Closed)
        return drawClosed;
    // Turned, one displacement becomes the other.
    const bool isHalfOpen = axis == SpanAxis::Column
        ? rule == FillRule::HalfOpenColumn
        : rule == FillRule::TopLeft && origin == FrameOrigin::BottomLeft;
    return isHalfOpen ? drawHalfOpen : nullptr;
}

Triangle triangleFor(const StraightLoop &loop, const Triangle &triangle)
{
    return loop.axis == SpanAxis::Row ? turned(triangle) : triangle;
}

RawFrame rawFrameFor(const StraightLoop &loop, const FrameView &frame)
{
    if (loop.axis == SpanAxis::Row)
        return {frame.base, -frame.firstRow, frame.firstColumn, -frame.stride, 1};
    return {frame.base, frame.firstColumn, frame.firstRow, 1, frame.stride};
}

} // namespace pixelplumb
