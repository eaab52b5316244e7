// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/strokes.h"

#include "core/effects/linecolours.h"
#include "core/effects/requirements.h"
#include "core/methods/strokerecording.h"

namespace pixelplumb {

namespace {

bool drawsStroke(const Primitives &primitives, std::size_t index)
{
    return !primitives.isTriangle(index) && isStroke(primitives.shape(index));
}

void drawStrokes(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    StrokeCanvas canvas(frame, strokeAntialiasing(primitives, frame));
    withDrawnColours(primitives, [&](const Primitives &drawn) {
        for (const Shape &shape : drawn.shapes) {
            if (isStroke(shape))
                StrokeScan(shape, settings, canvas, NullObserver{}).run();
        }
    });
}

std::unique_ptr<ScanTrace> traceStrokes(const Primitives &primitives, const ScanSettings &settings,
                                        FrameView frame, const TraceOptions &options)
{
    const Antialiasing antialiasing = strokeAntialiasing(primitives, frame);
    StrokeCanvas canvas(frame, antialiasing);
    return withDrawnColours(primitives, [&](const Primitives &drawn) {
        return recordTrace<StrokeRecording>(
            drawn.size(), settings, options,
            [&](std::size_t index) { return drawsStroke(drawn, index); },
            [&](std::size_t index, const ObserverOf<StrokeRecording> &recorder) {
                StrokeScan(drawn.shape(index), settings, canvas, recorder).run();
            },
            TablesOf<StrokeRecording>::of(antialiasing));
    });
}

} // namespace

Method strokeCoverageMethod()
{
    Method method;
    method.id = QStringLiteral("stroke-coverage");
    method.title = QStringLiteral("Line or curve: one pixel wide");
    method.family = MethodFamily::Curves;
    method.source
        = QStringLiteral("Rasterization slides, “Output Primitives” (lines, circles, other "
                         "curves); Foley 1990, unweighted area sampling");
    method.pseudocode = {
        {0,
         QStringLiteral("outline ← a quadrilateral one pixel wide of each straight piece"),
         {Moment::SetUp}},
        {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
        {0, QStringLiteral("for each column of the outline:"), {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("rows ← those whose pixel squares it meets"),
         {Moment::Begin, Moment::Span}},
        {1,
         QStringLiteral("for each of these rows:"),
         {Moment::First, Moment::Next, Moment::Refused}},
        {2,
         QStringLiteral("coverage ← the area of the outline in the square, or its samples in it"),
         {Moment::First, Moment::Next, Moment::Refused}},
        {2,
         QStringLiteral("pixel (x, y) ← so much of the colour over what stands there"),
         {Moment::First, Moment::Next}}};
    method.summary
        = QStringLiteral("Takes a line as the rectangle one pixel wide, a curve as a strip of "
                         "quadrilaterals, and blends it by the area that it has of each pixel, "
                         "equally bright in every direction, or by 4 or 16 samples, as the scene's "
                         "antialiasing asks. Where it asks for none, one sample decides a pixel: "
                         "stairs.");
    method.effects = {Effect::SmoothColour, Effect::Clipping, Effect::Antialiasing};
    method.remarks += QStringLiteral("butt ends");
    method.kinds = {PrimitiveKind::Line, PrimitiveKind::Circle, PrimitiveKind::Ellipse,
                    PrimitiveKind::Bezier};
    method.fills = {ShapeFill::Outline};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a pixel has a share of the stroke, not all or nothing");
    method.numbers = {descriptionsOf(StrokeRecording::setUpNumbers()),
                      descriptionsOf(StrokeRecording::spanNumbers()),
                      descriptionsOf(StrokeRecording::sampleNumbers())};
    method.draw = drawStrokes;
    method.trace = traceStrokes;
    return method;
}

} // namespace pixelplumb
