// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscan.h"

#include "core/fast/fastscan.h"
#include "core/methods/edgewalktraces.h"
#include "core/methods/plannedmethod.h"

namespace pixelplumb {

namespace {

void drawColumnsFast(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    drawFast(primitives.triangles, settings, frame);
}

} // namespace

Method columnScanMethod()
{
    Method method = edgeWalkMethod<ColumnScanKernel>();
    method.id = QStringLiteral("column-scan");
    method.title = QStringLiteral(QT_TRANSLATE_NOOP("core", "Column scan"));
    method.source = QStringLiteral("Assignment (Borst), “The Triangle Awakens” and “Smoothly "
                                   "shading the triangle”");
    method.summary = QStringLiteral(
        QT_TRANSLATE_NOOP("core",
                          "Walks the columns between two edges and colours the samples "
                          "from y_B to y_T that the fill rule takes, all by adding "
                          "increments."));
    method.shadedPseudocode = pixelplumb::shadedPseudocode(InterpolationForm::Bilinear);
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.effects.assign(allEffects.begin(), allEffects.end());
    method.shadingArithmetics = {Arithmetic::Exact, Arithmetic::Float32};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};
    method.variants = edgeWalkVariants();
    constexpr ShadedMethod shaded = ShadedMethod::ColumnScan;
    method.draw
        = drawVaried<drawPlanned<shaded, drawWith<ColumnScanKernel>>, drawWith<VariedColumnScan>>;
    method.drawFast = drawVaried<drawPlanned<shaded, drawColumnsFast>, drawWith<VariedColumnScan>>;
    method.drawEffects = drawEffects<shaded>;
    method.trace = traceVaried<tracePlanned<shaded, traceWith<ColumnScanKernel>>,
                               traceWith<VariedColumnScan>>;
    return method;
}

} // namespace pixelplumb
