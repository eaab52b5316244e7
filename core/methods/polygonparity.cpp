// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/kernelmethod.h"
#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"

namespace pixelplumb {

namespace {

struct ParityKernel : ShapeKernel<PrimitiveKind::Polygon>, InAnyArithmetic {
    template <class A>
    using Recording = PolygonRecording<A, PolygonForm::Whole>;

    static Contours geometryOf(const Primitives &primitives, std::size_t index)
    {
        return contoursOf(primitives.shape(index));
    }
    static IntegerWidth widthFor(const Contours &contours)
    {
        return integerWidthFor(contours.edges);
    }
    template <class A, class Observer>
    static void scan(const Contours &contours, const ScanSettings &, FrameView frame,
                     Observer observer)
    {
        scanPolygon<A>(contours, frame, observer);
    }
};

} // namespace

Method polygonMethod()
{
    Method method;
    method.family = MethodFamily::Polygons;
    method.kinds = {PrimitiveKind::Polygon};
    method.effects = {QStringLiteral("flat colour"), QStringLiteral("clipping to the frame")};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::TopLeft};
    method.fillRuleReason
        = QStringLiteral("a sample on the boundary of a polygon is in or out by the parity of "
                         "crossings, which is certain only for a sample displaced to the right "
                         "and a little downward");
    return method;
}

Method polygonParityMethod()
{
    Method method = polygonMethod();
    method.id = QStringLiteral("polygon-parity");
    method.title = QStringLiteral("Polygon by parity");
    method.source = QStringLiteral("seed 003, slide “Scan Conversion: A General Algorithm”");
    method.summary = QStringLiteral("Intersects each row with the active edges, sorts the "
                                    "crossings in x, and fills by their parity or winding number.");
    method.effects
        += {QStringLiteral("concave"), QStringLiteral("self-crossing"), QStringLiteral("holes"),
            QStringLiteral("even-odd"), QStringLiteral("non-zero")};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.setUpColumns = polygonSetUpColumns(PolygonForm::Whole);
    method.spanColumns = polygonRowColumns(PolygonForm::Whole);
    method.sampleColumns = polygonSampleColumns(PolygonForm::Whole);
    method.draw = drawWith<ParityKernel>;
    method.trace = traceWith<ParityKernel>;
    return method;
}

} // namespace pixelplumb
