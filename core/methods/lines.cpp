// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines.h"

#include "core/methods/linecolumns.h"
#include "core/methods/linerecording.h"
#include "core/methods/witharithmetic.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isLine(const Shape &shape) { return shape.kind == PrimitiveKind::Line; }

/// One trace has one number type: 128 bits as soon as one line needs them.
IntegerWidth widthFor(const Primitives &primitives)
{
    const auto isWide = [](const Vertex &vertex) {
        return absolute(vertex.position.x) > largestNarrowCoordinate
            || absolute(vertex.position.y) > largestNarrowCoordinate;
    };
    const bool anyWide = std::ranges::any_of(primitives.shapes, [&](const Shape &shape) {
        return isLine(shape) && std::ranges::any_of(shape.vertices, isWide);
    });
    return anyWide ? IntegerWidth::Bits128 : IntegerWidth::Bits64;
}

template <class Scan>
void drawLines(const Primitives &primitives, const Scan &scan)
{
    for (const Shape &shape : primitives.shapes) {
        if (isLine(shape))
            scan(shape);
    }
}

template <Recording R, class Scan>
std::unique_ptr<ScanTrace> traceLines(const Primitives &primitives, const ScanSettings &settings,
                                      const TraceOptions &options, const Scan &scan)
{
    return recordTrace<R>(
        primitives.size(), settings, options,
        [&](std::size_t primitive) {
            return !primitives.isTriangle(primitive) && isLine(primitives.shape(primitive));
        },
        [&](std::size_t primitive, const auto &recorder) {
            scan(primitives.shape(primitive), recorder);
        });
}

void drawDda(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    withArithmetic(settings.arithmetic, widthFor(primitives), [&]<class A>() {
        drawLines(primitives, [&](const Shape &line) {
            scanLineByDda<A>(line, settings.rounding, frame, NullObserver{});
        });
    });
}

std::unique_ptr<ScanTrace> traceDda(const Primitives &primitives, const ScanSettings &settings,
                                    FrameView frame, const TraceOptions &options)
{
    return withArithmetic(settings.arithmetic, widthFor(primitives), [&]<class A>() {
        return traceLines<DdaRecording<A>>(
            primitives, settings, options, [&](const Shape &line, const auto &recorder) {
                scanLineByDda<A>(line, settings.rounding, frame, recorder);
            });
    });
}

void drawSlopeIntercept(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    withArithmetic(settings.arithmetic, widthFor(primitives), [&]<class A>() {
        drawLines(primitives, [&](const Shape &line) {
            scanLineBySlopeIntercept<A>(line, settings.rounding, frame, NullObserver{});
        });
    });
}

std::unique_ptr<ScanTrace> traceSlopeIntercept(const Primitives &primitives,
                                               const ScanSettings &settings, FrameView frame,
                                               const TraceOptions &options)
{
    return withArithmetic(settings.arithmetic, widthFor(primitives), [&]<class A>() {
        return traceLines<SlopeInterceptRecording<A>>(
            primitives, settings, options, [&](const Shape &line, const auto &recorder) {
                scanLineBySlopeIntercept<A>(line, settings.rounding, frame, recorder);
            });
    });
}

void drawBresenham(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    drawLines(primitives, [&](const Shape &line) {
        scanLineByBresenham(line, settings.rounding, frame, NullObserver{});
    });
}

std::unique_ptr<ScanTrace> traceBresenham(const Primitives &primitives,
                                          const ScanSettings &settings, FrameView frame,
                                          const TraceOptions &options)
{
    return traceLines<BresenhamRecording>(
        primitives, settings, options, [&](const Shape &line, const auto &recorder) {
            scanLineByBresenham(line, settings.rounding, frame, recorder);
        });
}

void drawSymmetric(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    drawLines(primitives, [&](const Shape &line) {
        scanLineSymmetrically(line, settings.rounding, frame, NullObserver{});
    });
}

std::unique_ptr<ScanTrace> traceSymmetric(const Primitives &primitives,
                                          const ScanSettings &settings, FrameView frame,
                                          const TraceOptions &options)
{
    return traceLines<SymmetricRecording>(
        primitives, settings, options, [&](const Shape &line, const auto &recorder) {
            scanLineSymmetrically(line, settings.rounding, frame, recorder);
        });
}

/// What all line methods have in common.
Method lineMethod()
{
    Method method;
    method.family = MethodFamily::Lines;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.kinds = {PrimitiveKind::Line};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a line has no inside that an edge could bound");
    return method;
}

} // namespace

Method lineSlopeInterceptMethod()
{
    Method method = lineMethod();
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
    method.draw = drawSlopeIntercept;
    method.trace = traceSlopeIntercept;
    return method;
}

Method lineDdaMethod()
{
    Method method = lineMethod();
    method.id = QStringLiteral("line-dda");
    method.title = QStringLiteral("Line: DDA");
    method.source = QStringLiteral("seed 002, slide “DDA Line-Drawing Algorithm”");
    method.summary = QStringLiteral("Walks along the longer side and adds the slope at each step; "
                                    "the pixel is the nearest one.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.setUpColumns = ddaSetUpColumns();
    method.spanColumns = ddaColumns();
    method.draw = drawDda;
    method.trace = traceDda;
    return method;
}

Method lineBresenhamMethod()
{
    Method method = lineMethod();
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
    method.draw = drawBresenham;
    method.trace = traceBresenham;
    return method;
}

Method lineSymmetricMethod()
{
    Method method = lineMethod();
    method.id = QStringLiteral("line-bresenham-symmetric");
    method.title = QStringLiteral("Line: Bresenham, same both ways");
    method.source = QStringLiteral("stable form of seed 002, “Bresenham's Line Algorithm”");
    method.summary = QStringLiteral("Bresenham's decisions from any lattice point to any other, "
                                    "ties to the upper or right pixel whichever end comes first.");
    method.stableArithmetics = {Arithmetic::Exact};
    method.setUpColumns = symmetricSetUpColumns();
    method.spanColumns = symmetricColumns();
    method.draw = drawSymmetric;
    method.trace = traceSymmetric;
    return method;
}

} // namespace pixelplumb
