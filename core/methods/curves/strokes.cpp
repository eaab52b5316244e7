// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/strokerecording.h"
#include "core/methods/methodrows.h"
#include "core/shade/linecolours.h"

namespace pixelplumb {

namespace {

bool drawsStroke(const Primitives &primitives, std::size_t index)
{
    return !primitives.isTriangle(index) && isStroke(primitives.shape(index));
}

bool drawStrokes(const Run &run, FrameView frame, const ProgressListener &listener)
{
    StrokeCanvas canvas(frame, run.strokeAntialiasing());
    return withDrawnColours(run, [&](const Run &drawn) {
        for (std::size_t index = 0; index < drawn.primitives.size(); ++index) {
            if (!drawn.goesOnAt(index, listener))
                return false;
            if (drawsStroke(drawn.primitives, index))
                StrokeScan(drawn.primitives.shape(index), drawn.settings, canvas, NullObserver{})
                    .run();
        }
        return true;
    });
}

std::unique_ptr<ScanTrace> traceStrokes(const Run &run, FrameView frame,
                                        const TraceOptions &options)
{
    StrokeCanvas canvas(frame, run.strokeAntialiasing());
    return withDrawnColours(run, [&](const Run &drawn) {
        const Primitives &primitives = drawn.primitives;
        return recordTrace<StrokeRecording>(
            primitives.size(), drawn.settings, options,
            [&](std::size_t index) { return drawsStroke(primitives, index); },
            [&](std::size_t index, const ObserverOf<StrokeRecording> &recorder) {
                StrokeScan(primitives.shape(index), drawn.settings, canvas, recorder).run();
            },
            TablesOf<StrokeRecording>::of(run.strokeAntialiasing()));
    });
}

} // namespace

Method strokeCoverageMethod()
{
    Method method;
    method.id = "stroke-coverage";
    method.title = QT_TRANSLATE_NOOP("core", "Line or curve: one pixel wide");
    method.family = MethodFamily::Curves;
    method.source = "Rasterization slides, “Output Primitives” (lines, circles, other curves); "
                    "Foley 1990, unweighted area sampling";
    method.pseudocode
        = {{0, "outline ← a quadrilateral one pixel wide of each straight piece", {Moment::SetUp}},
           {0, "if no sample is to be drawn: done", {Moment::Rejected}},
           {0, "for each column of the outline:", {Moment::Begin, Moment::Span}},
           {1, "rows ← those whose pixel squares it meets", {Moment::Begin, Moment::Span}},
           {1, "for each of these rows:", {Moment::First, Moment::Next, Moment::Refused}},
           {2,
            "coverage ← the area of the outline in the square, or its samples in it",
            {Moment::First, Moment::Next, Moment::Refused}},
           {2,
            "pixel (x, y) ← so much of the colour over what stands there",
            {Moment::First, Moment::Next}}};
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Takes a line as the rectangle one pixel wide, a curve as a strip of quadrilaterals, and "
        "blends it by the area that it has of each pixel, equally bright in every direction, or by "
        "4 or 16 samples, as the scene's antialiasing asks. Where it asks for none, one sample "
        "decides a pixel: stairs.");
    method.effects = {Effect::SmoothColour, Effect::Clipping, Effect::Antialiasing};
    method.remarks += u"butt ends"_s;
    method.kinds = {PrimitiveKind::Line, PrimitiveKind::Circle, PrimitiveKind::Ellipse,
                    PrimitiveKind::Bezier};
    method.fills = {ShapeFill::Outline};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = "a pixel has a share of the stroke, not all or nothing";
    method.numbers = {descriptionsOf(StrokeRecording::setUpNumbers()),
                      descriptionsOf(StrokeRecording::spanNumbers()),
                      descriptionsOf(StrokeRecording::sampleNumbers())};
    method.draw = drawStrokes;
    method.trace = traceStrokes;
    return method;
}

} // namespace pixelplumb
