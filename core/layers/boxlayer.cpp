// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"
#include "core/polygons/contours.h"

#include <algorithm>
#include <array>

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

/// The ids by which edge tests number the first and last tested sample of a span.
struct TestedIds {
    SpanAxis axis;
    const char *first;
    const char *last;
};
constexpr std::array testedIds
    = {TestedIds{SpanAxis::Row, "x_min", "x_max"}, TestedIds{SpanAxis::Column, "y_min", "y_max"}};

/// The box of samples that the method tests, the same in each span from the first to the last; none
/// for a method that tests no box.
std::optional<SampleBox> testedBoxOf(const LayerMoment &moment)
{
    const ScanTrace &trace = moment.trace();
    const std::size_t firstSpan = trace.firstSpanOf(moment.primitive);
    std::size_t endSpan = trace.endSpanOf(moment.primitive);
    if (moment.hidesSteps()) {
        const std::optional<std::size_t> current = moment.currentSpan();
        endSpan = current ? *current + 1 : firstSpan;
    }
    if (firstSpan == endSpan)
        return std::nullopt;
    const SpanRecord record = trace.span(firstSpan);
    const NamedNumbers numbers(trace.numbers().span, record.cells);
    const std::int64_t begin = record.place.coordinate;
    const std::int64_t end = trace.placeOf(endSpan - 1).coordinate + 1;
    for (const TestedIds &ids : testedIds) {
        const Quantity first = numbers[QString::fromLatin1(ids.first)];
        const Quantity last = numbers[QString::fromLatin1(ids.last)];
        if (first.isNone() || last.isNone() || record.place.axis != ids.axis)
            continue;
        const auto from = std::int64_t(first.numerator());
        const auto to = std::int64_t(last.numerator()) + 1;
        return ids.axis == SpanAxis::Row ? SampleBox{from, to, begin, end}
                                         : SampleBox{begin, end, from, to};
    }
    return std::nullopt;
}

/// How one of the boxes looks.
struct BoxLook {
    LayerInk ink;
    LayerDrawing::Stroke stroke;
};

class BoxDrawer {
public:
    BoxDrawer(const FrameSpec &frame, LayerDrawing &drawing)
        : m_left(frame.firstColumn - 0.5)
        , m_low(frame.firstRow - 0.5)
        , m_right(m_left + frame.width)
        , m_high(m_low + frame.height)
        , m_drawing(drawing)
    {
    }

    void appendRectangle(const QPointF &first, const QPointF &last, const BoxLook &look)
    {
        const QPointF right(last.x(), first.y());
        const QPointF above(first.x(), last.y());
        m_drawing.lines.push_back({first, right, look.ink, look.stroke});
        m_drawing.lines.push_back({right, last, look.ink, look.stroke});
        m_drawing.lines.push_back({last, above, look.ink, look.stroke});
        m_drawing.lines.push_back({above, first, look.ink, look.stroke});
    }

    /// Places a label at the point of the frame nearest to a corner, which may lie far outside.
    void appendLabel(QString text, const QPointF &corner, LayerInk ink)
    {
        const QPointF place(std::clamp(corner.x(), m_left, m_right),
                            std::clamp(corner.y(), m_low, m_high));
        m_drawing.labels.push_back({withMinus(text), place, ink});
    }

    /// A box around the cells of its samples, with their first and last pixel named at a corner.
    void appendSamples(const SampleBox &box, const QString &name, const BoxLook &look)
    {
        const QPointF last = {double(box.endX) - 0.5, double(box.endY) - 0.5};
        if (box.isEmpty())
            return appendLabel(name + u": no pixel"_s, last, look.ink);
        appendRectangle({double(box.firstX) - 0.5, double(box.firstY) - 0.5}, last, look);
        appendLabel(u"%1: x %2 … %3, y %4 … %5"_s.arg(name)
                        .arg(box.firstX)
                        .arg(box.endX - 1)
                        .arg(box.firstY)
                        .arg(box.endY - 1),
                    last, look.ink);
    }

private:
    double m_left, m_low, m_right, m_high; ///< of the frame, px
    LayerDrawing &m_drawing;
};

void drawBox(const LayerMoment &moment, LayerDrawing &drawing)
{
    using Stroke = LayerDrawing::Stroke;
    const ContourBox raw = rawBoxOf(moment);
    if (raw.first.x > raw.last.x)
        return;
    const QPointF first = placeOf(raw.first);
    const QPointF last = placeOf(raw.last);
    BoxDrawer drawer(moment.frame(), drawing);
    drawer.appendRectangle(first, last, {LayerInk::Mark, Stroke::Dashed});
    drawer.appendLabel(u"bbox: x %1 … %2, y %3 … %4"_s.arg(
                           moment.inScene(raw.first.x), moment.inScene(raw.last.x),
                           moment.inScene(raw.first.y), moment.inScene(raw.last.y)),
                       {first.x(), last.y()}, LayerInk::Mark);
    const SampleBox frame = samplesOf(windowOf(moment.frame()));
    drawer.appendSamples(
        intersection(roundedSamplesIn(raw.first, raw.last, moment.frame().pixelCentre), frame),
        "(int)(bbox ± .5), clipped", {LayerInk::Second, Stroke::Dotted});
    const std::optional<SampleBox> tested = testedBoxOf(moment);
    const SampleBox clipped = intersection(samplesIn(raw.first, raw.last), frame);
    drawer.appendSamples(tested.value_or(clipped), tested ? u"tested"_s : u"clipped"_s,
                         {LayerInk::First, Stroke::Solid});
}

} // namespace

Layer boxLayer()
{
    return {.id = "box",
            .title = QT_TRANSLATE_NOOP("core", "Bounding box"),
            .toolTip
            = "The box around the vertices (dashed), clipped to the frame and rounded as the "
              "slides print it for samples in the middle of pixels, from (int)(bbox + .5) to "
              "(int)(bbox − .5) (dotted), and the pixels of the frame that the method tests "
              "(solid); where it tests no box, those that the box covers, exact.",
            .source = "Triangle Rasterization slides, “Edge equations rasterization” and “Triangle "
                      "rasterization implementation guidelines”; Scan Conversion slides, “Using "
                      "Edge Equations”",
            .kinds = {PrimitiveKind::Triangle, PrimitiveKind::Polygon},
            .draw = drawBox};
}

} // namespace pixelplumb
