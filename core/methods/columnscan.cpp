// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscan.h"

#include "core/fast/fastscan.h"
#include "core/methods/columnrecording.h"
#include "core/methods/columnscancolumns.h"
#include "core/methods/columnscanexplanation.h"
#include "core/methods/kernelmethod.h"
#include "core/oracle/oracle.h"
#include "core/trace/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

struct ColumnScanKernel : TriangleKernel, InAnyArithmetic {
    template <class A>
    using Recording = ColumnRecording<A>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        if (settings.fillRule == FillRule::HalfOpenColumn)
            ColumnScan<A, FillRule::HalfOpenColumn, Observer>(triangle, settings.rounding, frame,
                                                              observer)
                .run();
        else
            ColumnScan<A, FillRule::Closed, Observer>(triangle, settings.rounding, frame, observer)
                .run();
    }
};

std::vector<Quantity> exactSpan(const TracedScene &traced, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const auto column = oracle::columnAt(traced.primitives.triangles[trace.primitiveOf(span)],
                                         trace.settings().fillRule, trace.placeOf(span).coordinate);
    constexpr auto count = std::size_t(ColumnCell::Count);
    std::vector<Quantity> cells(count);
    if (!column)
        return cells;
    const auto at = [&cells](ColumnCell cell) { return cells.begin() + std::ptrdiff_t(cell); };
    *at(ColumnCell::YBottom) = column->yBottom;
    *at(ColumnCell::YTop) = column->yTop;
    *at(ColumnCell::FirstRow) = Quantity::integer(column->firstRow);
    *at(ColumnCell::LastRow) = Quantity::integer(column->endRow - 1);
    std::ranges::copy(column->colourBottom, at(ColumnCell::ColourBottom));
    std::ranges::copy(column->colourTop, at(ColumnCell::ColourTop));
    std::ranges::copy(column->colourRate, at(ColumnCell::ColourRate));
    return cells;
}

Explanation explain(const TracedScene &traced, std::size_t stepIndex)
{
    const TraceStep step = traced.trace->stepAt(stepIndex);
    switch (step.kind) {
    case StepKind::SetUp:
        return explainSetUp(traced, step.primitive);
    case StepKind::Span:
        return explainColumn(traced, step);
    case StepKind::Sample:
        return explainPixel(traced, step);
    }
    return {};
}

void drawColumnsFast(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    drawFast(primitives.triangles, settings, frame);
}

} // namespace

void drawColumns(std::span<const Triangle> triangles, const ScanSettings &settings, FrameView frame)
{
    for (const Triangle &triangle : triangles)
        drawGeometry<ColumnScanKernel>(triangle, settings, frame);
}

Method columnScanMethod()
{
    Method method;
    method.id = QStringLiteral("column-scan");
    method.title = QStringLiteral("Column scan");
    method.source = QStringLiteral("seed 004: the assignment, “scan by columns” and “Smoothly "
                                   "shading the triangle”");
    method.summary = QStringLiteral("Walks the columns between two edges and colours the samples "
                                    "from ⌈y_B⌉ to ⌊y_T⌋, all by adding increments.");
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn};
    method.fillRuleReason
        = QStringLiteral("a column ends at its two bounds whatever edge they belong to");
    method.setUpColumns = columnScanSetUpColumns();
    method.spanColumns = columnScanColumns();
    method.draw = drawWith<ColumnScanKernel>;
    method.drawFast = drawColumnsFast;
    method.trace = traceWith<ColumnScanKernel>;
    method.exactSpan = exactSpan;
    method.explain = explain;
    return method;
}

} // namespace pixelplumb
