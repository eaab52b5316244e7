// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/straightloop.h"

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
    for (const auto part : {straightColumns(), straightExactColumns(), straightSamples(),
                            straightExactSamples(), straightInterpolations()})
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

Triangle triangleFor(const StraightLoop &loop, const Triangle &triangle)
{
    Triangle turned = triangle;
    if (loop.isRowWalk) {
        for (Vertex &vertex : turned.vertices)
            vertex.position = {-vertex.position.y, vertex.position.x};
    }
    return turned;
}

RawFrame rawFrameFor(const StraightLoop &loop, const FrameView &frame)
{
    QRgb *const origin = frame.at(0, 0);
    return loop.isRowWalk ? RawFrame{origin, -frame.stride, 1} : RawFrame{origin, 1, frame.stride};
}

} // namespace pixelplumb
