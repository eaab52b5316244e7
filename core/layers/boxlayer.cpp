// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/polygons/contours.h"

#include <algorithm>

namespace pixelplumb {

namespace {

ContourBox rawBoxOf(const LayerMoment &moment)
{
    std::vector<ContourEdge> edges;
    if (!moment.primitives().isTriangle(moment.primitive))
        return boxAround(contoursOf(moment.shape()).edges);
    const auto &vertices = moment.triangle().vertices;
    for (std::size_t i = 0; i < 3; ++i)
        edges.push_back({vertices[i].position, vertices[(i + 1) % 3].position});
    return boxAround(edges);
}

/// `(int)` of the slides: towards 0.
std::int64_t printedPixel(Lattice sum) { return sum / unitsPerPixel; }

/// Triangle Rasterization slides, "Triangle rasterization implementation guidelines": left = (int)
/// (bbox + .5), right = (int) (bbox − .5), in the scene's coordinates. It is meant for pixels that
/// are sampled in their middles.
SampleBox printedBoxOf(const ContourBox &raw, const FrameSpec &frame)
{
    const Lattice first = sampleOffset(frame) + halfPixel;
    const Lattice last = sampleOffset(frame) - halfPixel;
    return {printedPixel(raw.first.x + first), printedPixel(raw.last.x + last) + 1,
            printedPixel(raw.first.y + first), printedPixel(raw.last.y + last) + 1};
}

/// The samples that the method visits, by its first and its last span; of a method that visits no
/// box, those of the box that the frame has.
SampleBox clippedBoxOf(const LayerMoment &moment, const ContourBox &raw)
{
    const ScanTrace &trace = moment.trace();
    const std::size_t first = trace.firstSpanOf(moment.primitive);
    const std::size_t end = trace.endSpanOf(moment.primitive);
    if (first < end) {
        const SpanRecord begin = trace.span(first);
        const SpanRecord last = trace.span(end - 1);
        const auto [low, high] = std::minmax(begin.place.coordinate, last.place.coordinate);
        const bool testsSamples = begin.lower.isNone() && begin.firstDrawn == last.firstDrawn
            && begin.endDrawn == last.endDrawn;
        if (testsSamples && begin.place.axis == SpanAxis::Row)
            return {begin.firstDrawn, begin.endDrawn, low, high + 1};
        if (testsSamples && begin.place.axis == SpanAxis::Column)
            return {low, high + 1, begin.firstDrawn, begin.endDrawn};
    }
    const SampleBox whole = {ceilPixel(raw.first.x), floorPixel(raw.last.x) + 1,
                             ceilPixel(raw.first.y), floorPixel(raw.last.y) + 1};
    return intersection(whole, samplesOf(windowOf(moment.frame())));
}

void appendLabel(QString text, const QPointF &place, LayerInk ink, LayerDrawing &drawing)
{
    drawing.labels.push_back({text.replace(u'-', QChar(0x2212)), place, ink});
}

void appendRectangle(const QPointF &first, const QPointF &last, LayerInk ink,
                     LayerDrawing::Stroke stroke, LayerDrawing &drawing)
{
    const QPointF right(last.x(), first.y());
    const QPointF above(first.x(), last.y());
    drawing.lines.push_back({first, right, ink, stroke});
    drawing.lines.push_back({right, last, ink, stroke});
    drawing.lines.push_back({last, above, ink, stroke});
    drawing.lines.push_back({above, first, ink, stroke});
}

/// Around the cells of its samples, with their first and last pixel at a corner.
void appendSamples(const SampleBox &box, const QString &name, LayerInk ink,
                   LayerDrawing::Stroke stroke, LayerDrawing &drawing)
{
    const QPointF last = {double(box.endX) - 0.5, double(box.endY) - 0.5};
    if (!box.isEmpty())
        appendRectangle({double(box.firstX) - 0.5, double(box.firstY) - 0.5}, last, ink, stroke,
                        drawing);
    appendLabel(box.isEmpty() ? name + QStringLiteral(": no pixel")
                              : QStringLiteral("%1: x %2 … %3, y %4 … %5")
                                    .arg(name)
                                    .arg(box.firstX)
                                    .arg(box.endX - 1)
                                    .arg(box.firstY)
                                    .arg(box.endY - 1),
                last, ink, drawing);
}

void drawBox(const LayerMoment &moment, LayerDrawing &drawing)
{
    const ContourBox raw = rawBoxOf(moment);
    if (raw.first.x > raw.last.x)
        return;
    const QPointF first = placeOf(raw.first);
    const QPointF last = placeOf(raw.last);
    appendRectangle(first, last, LayerInk::Mark, LayerDrawing::Stroke::Dashed, drawing);
    appendLabel(QStringLiteral("bbox: x %1 … %2, y %3 … %4")
                    .arg(moment.inScene(raw.first.x), moment.inScene(raw.last.x),
                         moment.inScene(raw.first.y), moment.inScene(raw.last.y)),
                {first.x(), last.y()}, LayerInk::Mark, drawing);
    appendSamples(printedBoxOf(raw, moment.frame()), QStringLiteral("(int)(bbox ± .5)"),
                  LayerInk::Second, LayerDrawing::Stroke::Dotted, drawing);
    appendSamples(clippedBoxOf(moment, raw), QStringLiteral("visited"), LayerInk::First,
                  LayerDrawing::Stroke::Solid, drawing);
}

} // namespace

Layer boxLayer()
{
    return {.id = QStringLiteral("box"),
            .title = QStringLiteral("Bounding box"),
            .toolTip = QStringLiteral(
                "The box around the vertices (dashed), the pixels from (int)(bbox + .5) to "
                "(int)(bbox − .5) as the slides print it for samples in the middle of pixels "
                "(dotted), and the pixels that the method visits, clipped to the frame (solid); "
                "where it visits no box, the box's own, exact."),
            .source = QStringLiteral("Triangle Rasterization slides, “Edge equations "
                                     "rasterization” and “Triangle rasterization implementation "
                                     "guidelines”; Scan Conversion slides, “Using Edge Equations”"),
            .kinds = {PrimitiveKind::Triangle, PrimitiveKind::Polygon},
            .draw = drawBox};
}

} // namespace pixelplumb
