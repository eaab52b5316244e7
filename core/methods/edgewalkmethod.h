// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalkcolumns.h"
#include "core/methods/edgewalkrecording.h"
#include "core/methods/kernelmethod.h"
#include "core/methods/method.h"

namespace pixelplumb {

template <EdgeWalkTable walkTable>
struct EdgeWalkKernel : TriangleKernel, InAnyArithmetic {
    static constexpr EdgeWalkTable table = walkTable;

    template <class A>
    using Recording = EdgeWalkRecording<A, table.axis, table.form>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        walkEdges<A, table.axis>(triangle, settings, frame, table.form, observer);
    }
};

/// What all walks have in common; the kernel is an EdgeWalkKernel, maybe with other numbers.
template <class Kernel>
Method edgeWalkMethod()
{
    Method method;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.setUpColumns = edgeWalkSetUpColumns(Kernel::table);
    method.spanColumns = edgeWalkSpanColumns(Kernel::table);
    method.sampleColumns = edgeWalkSampleColumns();
    method.draw = drawWith<Kernel>;
    method.trace = traceWith<Kernel>;
    return method;
}

} // namespace pixelplumb
