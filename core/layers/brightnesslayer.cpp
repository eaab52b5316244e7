// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layers.h"
#include "core/methods/method.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pixelplumb {

namespace {

constexpr double asideBy = 3; ///< px, from the line to the even line next to it

using Pixels = std::set<std::pair<std::int64_t, std::int64_t>>;

/// The line's pixels so far, each once.
Pixels pixelsOf(const LayerMoment &moment)
{
    Pixels pixels;
    const ScanTrace &trace = moment.trace();
    const std::size_t end = trace.endSpanOf(moment.primitive);
    for (std::size_t span = trace.firstSpanOf(moment.primitive);
         span < end && trace.indexOfSpan(span) < moment.view.position; ++span) {
        for (std::size_t i = trace.firstSampleOf(span); i < trace.endSampleOf(span); ++i) {
            if (trace.indexOfSample(i) < moment.view.position)
                pixels.emplace(trace.changes()[i].x, trace.changes()[i].y);
        }
    }
    return pixels;
}

/// How much of the line lies between the columns of the first and last pixel (rows if it is steep),
/// px.
double lengthBetween(const Pixels &pixels, const QLineF &line)
{
    const bool isSteep = std::abs(line.dy()) > std::abs(line.dx());
    const auto along = [&](const auto &pixel) { return isSteep ? pixel.second : pixel.first; };
    const auto [first, last] = std::ranges::minmax(pixels, {}, along);
    return double(along(last) - along(first)) * line.length()
        / std::abs(isSteep ? line.dy() : line.dx());
}

bool isInFrame(const LayerMoment &moment, const QPointF &place)
{
    const SampleBox frame = samplesOf(windowOf(moment.frame()));
    return double(frame.firstX) <= place.x() && place.x() <= double(frame.endX - 1)
        && double(frame.firstY) <= place.y() && place.y() <= double(frame.endY - 1);
}

QString figure(double number) { return QString::number(number, 'f', 2); }

QPointF normalOf(const QLineF &line)
{
    const QLineF across = line.normalVector().unitVector();
    return {across.dx(), across.dy()};
}

/// As much light as the line is long: a band one pixel wide.
void drawEvenLine(const QLineF &line, LayerDrawing &drawing)
{
    const QPointF normal = normalOf(line);
    const QPointF near = normal * (asideBy - 0.5);
    const QPointF far = normal * (asideBy + 0.5);
    drawing.areas.push_back(
        {{line.p1() + near, line.p2() + near, line.p2() + far, line.p1() + far}, LayerInk::Second});
    drawing.labels.push_back({u"even: 1 px wide, %1 px of light"_s.arg(figure(line.length())),
                              line.center() + far, LayerInk::Second});
}

void drawBrightness(const LayerMoment &moment, LayerDrawing &drawing)
{
    const Shape &shape = moment.shape();
    const QLineF line(placeOf(shape.vertices[0].position), placeOf(shape.vertices[1].position));
    if (line.length() < 1 || !isInFrame(moment, line.p1()) || !isInFrame(moment, line.p2())) {
        drawing.notes.append(
            u"Brightness by direction: only of a line of 1 px or more that lies in the frame"_s);
        return;
    }
    // The even line is on the other side.
    const LayerDrawing::HalfPlane side{line.center(), -normalOf(line)};
    const Pixels pixels = pixelsOf(moment);
    const ScanTrace &trace = moment.trace();
    const std::size_t end = trace.endSpanOf(moment.primitive);
    const bool isDone = end > trace.firstSpanOf(moment.primitive) && moment.currentSpan() == end - 1
        && moment.view.position >= trace.indexOfSpan(end - 1) + 2;
    if (!isDone || pixels.size() < 2) {
        const QString count = pixels.size() == 1 ? u"1 pixel"_s : u"%1 pixels"_s.arg(pixels.size());
        drawing.labels.push_back({isDone ? count : count + u" so far"_s,
                                  line.center(),
                                  LayerInk::First,
                                  side,
                                  {line.p1(), line.p2()}});
        return;
    }
    // From the first pixel to the last there is one step fewer than pixels.
    const double between = lengthBetween(pixels, line);
    const double each = double(pixels.size() - 1) / between;
    drawing.labels.push_back(
        {u"(%1 − 1) pixels / %2 px = %3 a px; even with %4 times the light"_s.arg(
             QString::number(pixels.size()), figure(between), figure(each), figure(1 / each)),
         line.center(),
         LayerInk::First,
         side,
         {line.p1(), line.p2()}});
    drawEvenLine(line, drawing);
}

/// Those that write a pixel a step, and so draw a line brighter on the level than at 45°.
QStringList thinLineMethods()
{
    QStringList ids;
    for (const Method &method : methods()) {
        if (method.family == MethodFamily::Lines)
            ids += method.id;
    }
    return ids;
}

} // namespace

Layer brightnessLayer()
{
    return {.id = "brightness",
            .title = QT_TRANSLATE_NOOP("core", "Brightness by direction"),
            .toolTip
            = "Of a line, its pixels for each pixel of its length, from the first to the last: 1 "
              "on the level, 1/√2 at 45°; beside it a line of even brightness, one pixel wide.",
            .source = "Rasterization slides, “Raster Conversion of Lines”",
            .kinds = {PrimitiveKind::Line},
            .methods = thinLineMethods(),
            .draw = drawBrightness};
}

} // namespace pixelplumb
