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

/// A line's colour changes evenly along it, and is its end's beyond it.
Pseudocode strokePseudocode()
{
    using enum Moment;
    const std::vector<Moment> all = {First, Next, Refused}, written = {First, Next};
    const std::vector<Antialiasing> one = {Antialiasing::None}, area = {Antialiasing::Area},
                                    several = {Antialiasing::Samples4, Antialiasing::Samples16};
    Pseudocode code;
    const auto add = [&code](int depth, const QString &text, const std::vector<Moment> &moments,
                             const std::vector<Antialiasing> &antialiasing = {}) {
        code.push_back(
            {.depth = depth, .text = text, .moments = moments, .antialiasing = antialiasing});
    };
    add(0, "given: the outline, a quadrilateral one pixel wide of each straight piece", {SetUp});
    add(0, "given: share(x, y), ⌊255·area + ½⌋ of the outline in the pixel's square, −1 if none",
        {SetUp}, area);
    add(0, "given: covers(x, y), 1 where the outline goes around the place, else 0", {SetUp}, one);
    add(0,
        "given: covers(x, y), 1 where the outline goes around the place, else 0; way(k), from the "
        "centre of a pixel to its sample k",
        {SetUp}, several);
    add(0, "given: R₁, G₁, B₁ of a curve are R₀, G₀, B₀", {SetUp});
    add(0, "if no sample is to be drawn: done", {Rejected});
    add(0, "for each column x of the frame from x_first to x_last: — that the outline meets",
        {Begin, Span});
    add(1, "for each row y of the frame from y_first to y_last: — that it meets there", all);
    add(2, "a ← share(x, y)", all, area);
    add(2, "if a < 0: on to the next row", all, area);
    add(2, "c ← covers(x, y)", all, one);
    add(2, "if c = 0: on to the next row", all, one);
    const auto addColour = [&](int depth, const QString &x, const QString &y,
                               const std::vector<Antialiasing> &antialiasing) {
        add(depth,
            u"t ← ((%1 − x₀)·(x₁ − x₀) + (%2 − y₀)·(y₁ − y₀))/((x₁ − x₀)² + (y₁ − y₀)²) if x₀ ≠ "
            u"x₁, "
            "or y₀ ≠ y₁, else 0"_s.arg(x, y),
            written, antialiasing);
        add(depth, "t ← 0 if t < 0, else 1 if t > 1, else t", written, antialiasing);
        add(depth,
            "R_s, G_s, B_s ← the bytes of R₀ + t·(R₁ − R₀), G₀ + t·(G₁ − G₀), B₀ + t·(B₁ − "
            "B₀)",
            written, antialiasing);
    };
    std::vector<Antialiasing> oneOrArea = one;
    oneOrArea.push_back(Antialiasing::Area);
    addColour(2, "x", "y", oneOrArea);
    add(2, "R_d, G_d, B_d ← pixel (x, y)", written, area);
    add(2, "R_s ← ⌊(R_s·a + R_d·(255 − a))/255 + ½⌋; G_s and B_s likewise", written, area);
    add(2, "pixel (x, y) ← the bytes of R_s, G_s, B_s", written, oneOrArea);
    add(2, "for each sample k from 1 to n:", all, several);
    add(3, "d_x, d_y ← way(k)", all, several);
    add(3, "c ← covers(x + d_x, y + d_y)", all, several);
    add(3, "if c = 0: on to the next sample", all, several);
    addColour(3, "x + d_x", "y + d_y", several);
    add(3, "R[k, x, y], G[k, x, y], B[k, x, y] ← R_s, G_s, B_s", written, several);
    add(3,
        "pixel (x, y) ← the mean of its samples — ⌊(R[1, x, y] + … + R[n, x, y])/n + ½⌋; G and B "
        "likewise",
        written, several);
    return code;
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
    method.pseudocode = strokePseudocode();
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
