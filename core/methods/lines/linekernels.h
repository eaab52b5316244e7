// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/lines/linerecording.h"

/// The kernels of lines in the form that kernelmethod.h requires.
namespace pixelplumb {

struct SlopeInterceptKernel : ShapeKernel<PrimitiveKind::Line>, InAnyArithmetic {
    template <class A>
    using Recording = SlopeInterceptRecording<A>;

    template <class A, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineBySlopeIntercept<A>(line, settings.rounding, frame, observer);
    }
};

struct DdaKernel : ShapeKernel<PrimitiveKind::Line>, InAnyArithmetic {
    template <class A>
    using Recording = DdaRecording<A>;

    template <class A, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineByDda<A>(line, settings, frame, observer);
    }
};

struct ParametricLineKernel : ShapeKernel<PrimitiveKind::Line>, InAnyArithmetic {
    template <class A>
    using Recording = ParametricLineRecording<A>;

    template <class A, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineParametrically<A>(line, settings, frame, observer);
    }
};

struct BresenhamKernel : ShapeKernel<PrimitiveKind::Line>, InIntegers {
    template <class>
    using Recording = BresenhamRecording;

    template <class A, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineByBresenham<NarrowBeside<typename A::Number>>(line, settings, frame, observer);
    }
};

struct SymmetricKernel : ShapeKernel<PrimitiveKind::Line>, InIntegers {
    template <class>
    using Recording = SymmetricRecording;

    template <class A, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineSymmetrically<WideBeside<typename A::Number>>(line, settings.rounding, frame,
                                                              observer);
    }
};

} // namespace pixelplumb
