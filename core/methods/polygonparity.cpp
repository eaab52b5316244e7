// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygonrecording.h"
#include "core/methods/polygons.h"
#include "core/methods/witharithmetic.h"

#include <algorithm>

namespace pixelplumb {

namespace {

bool isPolygon(const Primitives &primitives, std::size_t primitive)
{
    return primitives.kindOf(primitive) == PrimitiveKind::Polygon;
}

void draw(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    for (const Shape &shape : primitives.shapes) {
        if (shape.kind != PrimitiveKind::Polygon)
            continue;
        const Contours contours = contoursOf(shape);
        withArithmetic(settings.arithmetic, integerWidthFor(contours.edges),
                       [&]<class A>() { scanPolygon<A>(contours, frame, NullObserver{}); });
    }
}

/// One trace has one number type: 128 bits as soon as one polygon needs them.
IntegerWidth widestOf(const Primitives &primitives)
{
    const bool isWide = std::ranges::any_of(primitives.shapes, [](const Shape &shape) {
        return shape.kind == PrimitiveKind::Polygon
            && integerWidthFor(contoursOf(shape).edges) == IntegerWidth::Bits128;
    });
    return isWide ? IntegerWidth::Bits128 : IntegerWidth::Bits64;
}

std::unique_ptr<ScanTrace> trace(const Primitives &primitives, const ScanSettings &settings,
                                 FrameView frame, const TraceOptions &options)
{
    return withArithmetic(settings.arithmetic, widestOf(primitives), [&]<class A>() {
        return recordTrace<PolygonRecording<A, PolygonForm::Whole>>(
            primitives.size(), settings, options,
            [&](std::size_t primitive) { return isPolygon(primitives, primitive); },
            [&](std::size_t primitive, const auto &recorder) {
                scanPolygon<A>(contoursOf(primitives.shape(primitive)), frame, recorder);
            });
    });
}

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
    method.draw = draw;
    method.trace = trace;
    return method;
}

} // namespace pixelplumb
