// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/methods/kernelnumbers.h"
#include "core/scan/scanobserver.h"
#include "core/trace/tracerecorder.h"

#include <memory>

/// How a kernel becomes a method: drawWith<Kernel> and traceWith<Kernel> are its Method::draw and
/// Method::trace. A kernel says, in static members,
///   draws(primitives, index)       whether a primitive is of its kind;
///   geometryOf(primitives, index)  what is scanned of it;
///   widthFor(geometry)             which integers hold the exact products of that;
///   withNumbers(settings, width, function)
///                                  calls function.operator()<A>(), A being what it computes in;
///   Recording<A>                   how these numbers become records;
///   scan<A>(geometry, settings, frame, observer).
/// The first two are mostly a TriangleKernel's or a ShapeKernel's, the next two one of
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

/// Draws one primitive, in the narrowest integers that hold it.
template <class Kernel, class Geometry>
void drawGeometry(const Geometry &geometry, const ScanSettings &settings, FrameView frame)
{
    Kernel::withNumbers(settings, Kernel::widthFor(geometry), [&]<class A>() {
        Kernel::template scan<A>(geometry, settings, frame, NullObserver{});
    });
}

template <class Kernel>
void drawWith(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        if (Kernel::draws(primitives, index))
            drawGeometry<Kernel>(Kernel::geometryOf(primitives, index), settings, frame);
    }
}

/// One trace has one number type: 128 bits as soon as one primitive needs them. The numbers are the
/// same.
template <class Kernel>
IntegerWidth widestFor(const Primitives &primitives)
{
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        if (Kernel::draws(primitives, index)
            && Kernel::widthFor(Kernel::geometryOf(primitives, index)) == IntegerWidth::Bits128)
            return IntegerWidth::Bits128;
    }
    return IntegerWidth::Bits64;
}

template <class Kernel>
std::unique_ptr<ScanTrace> traceWith(const Primitives &primitives, const ScanSettings &settings,
                                     FrameView frame, const TraceOptions &options)
{
    return Kernel::withNumbers(settings, widestFor<Kernel>(primitives), [&]<class A>() {
        return recordTrace<typename Kernel::template Recording<A>>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return Kernel::draws(primitives, index); },
            [&](std::size_t index, const auto &recorder) {
                Kernel::template scan<A>(Kernel::geometryOf(primitives, index), settings, frame,
                                         recorder);
            });
    });
}

} // namespace pixelplumb
