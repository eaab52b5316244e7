// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/fastscan.h"
#include "core/methods/methodrows.h"
#include "core/methods/shading/plannedmethod.h"
#include "core/methods/walklisting.h"
#include "core/methods/walks/edgewalktraces.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

namespace {

/// By core/fast unless the run asks for the plain kernel, in pieces of some milliseconds.
bool drawColumnScan(const Run &run, FrameView frame, const ProgressListener &listener)
{
    if (run.kernels == Kernels::Plain)
        return drawWith<ColumnScanKernel>(run, frame, listener);
    constexpr std::size_t pieceSize = std::size_t(1) << 16;
    FastOptions options;
    options.threads = run.kernels == Kernels::FastestOnOneThread ? 1 : 0;
    const std::span<const Triangle> triangles = run.primitives.triangles;
    for (std::size_t first = 0; first < triangles.size(); first += pieceSize) {
        if (!run.goesOnAt(first, listener))
            return false;
        drawFast(triangles.subspan(first, std::min(pieceSize, triangles.size() - first)),
                 run.settings, frame, options);
    }
    return true;
}

} // namespace

Method columnScanMethod()
{
    Method method = edgeWalkMethod<ColumnScanKernel>();
    method.id = "column-scan";
    method.title = QT_TRANSLATE_NOOP("core", "Column scan");
    method.source
        = "Assignment (Borst), “The Triangle Awakens” and “Smoothly shading the triangle”";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Walks the columns between two edges and colours the samples from y_B "
                            "to y_T that the fill rule takes, all by adding increments.");
    method.shadedPseudocode = shadedColumnScanPseudocode();
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.effects.assign(allEffects.begin(), allEffects.end());
    method.shadingArithmetics = {Arithmetic::Exact, Arithmetic::Float32};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};
    method.variants = edgeWalkVariants();
    method.hasFastKernels = true;
    constexpr ShadedMethod shaded = ShadedMethod::ColumnScan;
    method.draw = drawVaried<drawPlanned<shaded, drawColumnScan>, drawWith<VariedColumnScan>>;
    method.trace = traceVaried<tracePlanned<shaded, traceWith<ColumnScanKernel>>, VariedColumnScan>;
    return method;
}

} // namespace pixelplumb
