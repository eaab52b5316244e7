// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines.h"

#include "core/methods/kernelmethod.h"
#include "core/methods/linecolumns.h"
#include "core/methods/linerecording.h"

namespace pixelplumb {

namespace {

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
        scanLineByDda<A>(line, settings.rounding, frame, observer);
    }
};

struct BresenhamKernel : ShapeKernel<PrimitiveKind::Line>, InIntegers {
    template <class>
    using Recording = BresenhamRecording;

    template <class, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineByBresenham(line, settings.rounding, frame, observer);
    }
};

struct SymmetricKernel : ShapeKernel<PrimitiveKind::Line>, InIntegers {
    template <class>
    using Recording = SymmetricRecording;

    template <class, class Observer>
    static void scan(const Shape &line, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        scanLineSymmetrically(line, settings.rounding, frame, observer);
    }
};

/// What all line methods have in common.
template <class Kernel>
Method lineMethod()
{
    Method method;
    method.family = MethodFamily::Lines;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.kinds = {PrimitiveKind::Line};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a line has no inside that an edge could bound");
    method.draw = drawWith<Kernel>;
    method.trace = traceWith<Kernel>;
    return method;
}

} // namespace

Method lineSlopeInterceptMethod()
{
    Method method = lineMethod<SlopeInterceptKernel>();
    method.id = QStringLiteral("line-slope-intercept");
    method.title = QStringLiteral("Line: y = m·x + b");
    method.source = QStringLiteral("seed 002, slides “Line-Drawing Algorithms” and “Example”; "
                                   "seed 003, “Lines and Curves: Explicit”");
    method.summary = QStringLiteral("Computes y = m·x + b for each column and rounds it by "
                                    "(int)(y + ½): steep lines have gaps, vertical ones no m.");
    method.effects += QStringLiteral("gaps where |m| > 1");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.setUpColumns = slopeInterceptSetUpColumns();
    method.spanColumns = slopeInterceptColumns();
    return method;
}

Method lineDdaMethod()
{
    Method method = lineMethod<DdaKernel>();
    method.id = QStringLiteral("line-dda");
    method.title = QStringLiteral("Line: DDA");
    method.source = QStringLiteral("seed 002, slide “DDA Line-Drawing Algorithm”");
    method.summary = QStringLiteral("Walks along the longer side and adds the slope at each step; "
                                    "the pixel is the nearest one.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.setUpColumns = ddaSetUpColumns();
    method.spanColumns = ddaColumns();
    return method;
}

Method lineBresenhamMethod()
{
    Method method = lineMethod<BresenhamKernel>();
    method.id = QStringLiteral("line-bresenham");
    method.title = QStringLiteral("Line: Bresenham");
    method.source = QStringLiteral("seed 002, slides “Bresenham's Line Algorithm (1/4)” to "
                                   "“(4/4)” and “Bresenham: Example”");
    method.summary = QStringLiteral("Steps from the first end to the second by the sign of an "
                                    "integer; p_k < 0 stays, so that ties depend on the "
                                    "direction.");
    method.effects += QStringLiteral("whole-pixel end points");
    method.setUpColumns = bresenhamSetUpColumns();
    method.spanColumns = bresenhamColumns();
    return method;
}

Method lineSymmetricMethod()
{
    Method method = lineMethod<SymmetricKernel>();
    method.id = QStringLiteral("line-bresenham-symmetric");
    method.title = QStringLiteral("Line: Bresenham, same both ways");
    method.source = QStringLiteral("stable form of seed 002, “Bresenham's Line Algorithm”");
    method.summary = QStringLiteral("Bresenham's decisions from any lattice point to any other, "
                                    "ties to the upper or right pixel whichever end comes first.");
    method.stableArithmetics = {Arithmetic::Exact};
    method.setUpColumns = symmetricSetUpColumns();
    method.spanColumns = symmetricColumns();
    return method;
}

} // namespace pixelplumb
