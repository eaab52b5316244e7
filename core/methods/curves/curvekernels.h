// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/circlerecording.h"
#include "core/methods/curves/curvenumbers.h"
#include "core/methods/curves/flatrecording.h"
#include "core/methods/kernelmethod.h"

/// The kernels of circles, ellipses and points in the form that kernelmethod.h requires.
namespace pixelplumb {

struct PointRecording : PointNumbers, FlatRecording {
    static const auto &setUpNumbers() { return pointSetUpNumbers(); }
    static const auto &spanNumbers() { return pointNumbers(); }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
};

using RoundKernel = ShapeKernel<PrimitiveKind::Circle, PrimitiveKind::Ellipse>;

struct OutlineKernel : RoundKernel {
    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return RoundKernel::draws(primitives, index)
            && primitives.shape(index).fill == ShapeFill::Outline;
    }
};

struct ExplicitKernel : OutlineKernel,
                        InExactOrFloat<ExactArithmetic<Int128>, ExactArithmetic<Int128>,
                                       RoundedArithmetic<float>, RoundedArithmetic<double>> {
    template <class A>
    using Recording = CircleExplicitRecording<A>;

    template <class A, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        scanCircleExplicitly<A>(shape, frame, observer);
    }
};

/// Has no exact numbers: double comes closest.
struct ParametricKernel : OutlineKernel, InExactOrFloat<double, double, float, double> {
    template <class Float>
    using Recording = CircleParametricRecording<Float>;

    template <class Float, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        scanCircleParametrically<Float>(shape, frame, observer);
    }
};

struct MidpointKernel : OutlineKernel, InIntegers {
    template <class>
    using Recording = MidpointRecording;

    template <class A, class Observer>
    static void scan(const Shape &shape, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanCircleByMidpoint<WideBeside<typename A::Number>>(shape, settings.variants, frame,
                                                             observer);
    }
};

struct FillKernel : RoundKernel, InIntegers {
    template <class>
    using Recording = CircleFillRecording;

    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return RoundKernel::draws(primitives, index)
            && primitives.shape(index).fill != ShapeFill::Outline;
    }
    template <class A, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        fillCircle<WideBeside<typename A::Number>>(shape, frame, observer);
    }
};

struct PointKernel : ShapeKernel<PrimitiveKind::Point>, InIntegers {
    template <class>
    using Recording = PointRecording;

    template <class A, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        plotPoints<NarrowBeside<typename A::Number>>(shape, frame, observer);
    }
};

} // namespace pixelplumb
