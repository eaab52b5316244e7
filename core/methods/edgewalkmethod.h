// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalkcolumns.h"
#include "core/methods/edgewalkrecording.h"
#include "core/methods/method.h"
#include "core/methods/witharithmetic.h"

namespace pixelplumb {

/// Draws triangles by a walk. Walk::withNumbers(settings, width, function) calls the function with
/// the arithmetic; Walk::axis and Walk::form say which walk it is.
template <class Walk>
void drawByEdgeWalk(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    for (const Triangle &triangle : primitives.triangles) {
        Walk::withNumbers(settings, integerWidthFor(triangle), [&]<class A>() {
            walkEdges<A, Walk::axis>(triangle, settings, frame, Walk::form, NullObserver{});
        });
    }
}

template <class Walk>
std::unique_ptr<ScanTrace> traceEdgeWalk(const Primitives &primitives, const ScanSettings &settings,
                                         FrameView frame, const TraceOptions &options)
{
    return Walk::withNumbers(settings, widestOf(primitives.triangles), [&]<class A>() {
        return recordTrace<EdgeWalkRecording<A, Walk::axis, Walk::form>>(
            primitives.size(), settings, options,
            [&](std::size_t primitive) { return primitives.isTriangle(primitive); },
            [&](std::size_t primitive, const auto &recorder) {
                walkEdges<A, Walk::axis>(primitives.triangles[primitive], settings, frame,
                                         Walk::form, recorder);
            });
    });
}

template <class Walk>
Method edgeWalkMethod()
{
    const EdgeWalkTable table{Walk::axis, Walk::form, Walk::rate};
    Method method;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.setUpColumns = edgeWalkSetUpColumns(table);
    method.spanColumns = edgeWalkSpanColumns(table);
    method.sampleColumns = edgeWalkSampleColumns();
    method.draw = drawByEdgeWalk<Walk>;
    method.trace = traceEdgeWalk<Walk>;
    return method;
}

} // namespace pixelplumb
