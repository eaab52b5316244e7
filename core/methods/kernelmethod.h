// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/methods/method.h"
#include "core/methods/onefunction.h"
#include "core/scan/kernelnumbers.h"
#include "core/scan/scanobserver.h"
#include "core/trace/statesof.h"

#include <concepts>
#include <memory>

/// How a kernel becomes a method: methodOf<Kernel>() draws, traces and describes numbers with it.
/// A kernel says, in static members,
///   draws(primitives, index)       whether a primitive is of its kind;
///   geometryOf(primitives, index)  the geometry to scan;
///   widthFor(geometry, frame)      which integers hold the exact products of that;
///   withNumbers(settings, width, function)
///                                  calls function.operator()<A>(), A being what it computes in;
///   Recording<A>                   how these numbers become records (trace/recording.h);
///   scan<A>(geometry, settings, frame, observer).
/// The first two usually come from TriangleKernel or ShapeKernel, the next two from
/// kernelnumbers.h.
namespace pixelplumb {

struct TriangleKernel {
    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return primitives.isTriangle(index);
    }
    static const Triangle &geometryOf(const Primitives &primitives, std::size_t index)
    {
        return primitives.triangles[index];
    }
};

template <PrimitiveKind... kinds>
struct ShapeKernel {
    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return ((primitives.kindOf(index) == kinds) || ...);
    }
    static const Shape &geometryOf(const Primitives &primitives, std::size_t index)
    {
        return primitives.shape(index);
    }
};

/// Draws one primitive, in the narrowest integers that hold its products.
template <class Kernel, class Geometry>
void drawGeometry(const Geometry &geometry, const ScanSettings &settings, FrameView frame)
{
    Kernel::withNumbers(settings, Kernel::widthFor(geometry, frame), [&]<class A>() {
        const auto scan
            = [&] { Kernel::template scan<A>(geometry, settings, frame, NullObserver{}); };
        if constexpr (std::derived_from<Kernel, TriangleKernel> && !isWide<A>)
            inOneFunction(scan);
        else
            scan();
    });
}

using DrawFunction = bool(const Run &, FrameView, const ProgressListener &);

/// False if the listener ended it.
template <class Kernel>
bool drawWith(const Run &run, FrameView frame, const ProgressListener &listener)
{
    const Primitives &primitives = run.primitives;
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        if (!run.goesOnAt(index, listener))
            return false;
        if (Kernel::draws(primitives, index))
            drawGeometry<Kernel>(Kernel::geometryOf(primitives, index), run.settings, frame);
    }
    return true;
}

using TraceFunction = std::unique_ptr<ScanTrace>(const Run &, FrameView, const TraceOptions &);

/// A trace has one number type, the widest.
template <class Kernel>
std::unique_ptr<ScanTrace> traceWith(const Run &run, FrameView frame, const TraceOptions &options)
{
    const Primitives &primitives = run.primitives;
    const ScanSettings &settings = run.settings;
    return Kernel::withNumbers(settings, IntegerWidth::Bits128, [&]<class A>() {
        using Widest = WidestOf<A>;
        return recordTrace<typename Kernel::template Recording<Widest>>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return Kernel::draws(primitives, index); },
            [&](std::size_t index, const auto &recorder) {
                Kernel::template scan<Widest>(Kernel::geometryOf(primitives, index), settings,
                                              frame, recorder);
            });
    });
}

/// A method that draws, traces and describes its numbers with the kernel; its names and choices are
/// still to be filled in.
template <class Kernel>
Method methodOf()
{
    Method method;
    method.draw = drawWith<Kernel>;
    method.trace = traceWith<Kernel>;
    // The descriptions are the same in every arithmetic.
    Kernel::withNumbers(ScanSettings{}, IntegerWidth::Bits128, [&]<class A>() {
        using Recording = typename Kernel::template Recording<WidestOf<A>>;
        method.numbers.setUp = descriptionsOf(Recording::setUpNumbers());
        method.numbers.span = descriptionsOf(Recording::spanNumbers());
        method.numbers.sample = descriptionsOf(Recording::sampleNumbers());
    });
    return method;
}

} // namespace pixelplumb
