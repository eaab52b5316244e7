// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/svgexport.h"

#include "core/layers/layer.h"
#include "core/scene/files/fileaccess.h"
#include "widgets/canvas/ruler.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/framepainter.h"
#include "widgets/model/playhead.h"

#include <QSvgGenerator>
#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int cellSize = 16; ///< room for a glyph
constexpr int numberCellSize = 32; ///< room for the numbers of layers
constexpr int smallestCellSize = 4;
constexpr int largestSide = 4096; ///< of the figure; larger frames get smaller cells
constexpr double margin = 16;
constexpr int fontSize = 13;

/// The palette of figures, for paper whatever the window looks like.
QPalette paperPalette()
{
    QPalette palette(Qt::white);
    palette.setColor(QPalette::Window, Qt::white);
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::WindowText, Qt::black);
    palette.setColor(QPalette::Text, Qt::black);
    return palette;
}

/// The parts of the figure: rulers at the left and below or above, as on the canvas.
struct Layout {
    ViewMapping mapping;
    QRectF view;
    QRectF columnRuler;
    QRectF rowRuler;
    QSize size;
};

Layout layOut(const FrameSpec &frame, const QFontMetricsF &metrics, int largestCell)
{
    const int cell = std::clamp(largestSide / std::max(frame.width, frame.height), smallestCellSize,
                                largestCell);
    const double rulerWidth = rowRulerWidth(metrics, frame);
    const double rulerHeight = columnRulerHeight(metrics);
    const bool below = frame.origin == FrameOrigin::BottomLeft;
    const QSizeF viewSize(frame.width * cell + 2 * margin, frame.height * cell + 2 * margin);
    const QRectF view({rulerWidth, below ? 0 : rulerHeight}, viewSize);
    Layout layout;
    layout.mapping = ViewMapping(frame, ViewZoom::fromNumber(cell),
                                 (view.topLeft() + QPointF(margin, margin)).toPoint());
    layout.view = view;
    layout.columnRuler = {view.left(), below ? view.bottom() : 0, view.width(), rulerHeight};
    layout.rowRuler = {0, view.top(), rulerWidth, view.height()};
    layout.size = {int(view.width() + rulerWidth), int(view.height() + rulerHeight)};
    return layout;
}

void drawCells(QPainter &painter, const QImage &picture, const ViewMapping &mapping)
{
    const double cell = mapping.zoom().devicePixels;
    for (int line = 0; line < picture.height(); ++line) {
        const auto *const pixels = reinterpret_cast<const QRgb *>(picture.constScanLine(line));
        int end = 0;
        for (int first = 0; first < picture.width(); first = end) {
            end = first + 1;
            while (end < picture.width() && pixels[end] == pixels[first])
                ++end;
            const QPointF corner = mapping.origin() + QPointF(first, line) * cell;
            painter.fillRect(QRectF(corner, QSizeF((end - first) * cell, cell)),
                             QColor::fromRgb(pixels[first]));
        }
    }
}

void drawDifferences(QPainter &painter, const TracedScene &traced, std::size_t position,
                     const ViewMapping &mapping, const QPalette &palette)
{
    if (traced.differences.total() == 0)
        return;
    const FrameSpec &frame = traced.scene.frame;
    forEachPixel(frame, QRect(0, 0, frame.width, frame.height), [&](const QPoint &at) {
        if (traced.decidedAt(at.x(), at.y()) <= position)
            paintDifference(painter, mapping.cellOf(at), traced.differences.at(at.x(), at.y()),
                            palette);
    });
}

void drawTriangles(QPainter &painter, FramePainter &frame, const Playhead &playhead,
                   const ViewMapping &mapping)
{
    const TracedScene &traced = *playhead.traced();
    const std::optional<TraceStep> step = playhead.currentStep();
    const std::size_t current = step ? step->primitive : 0;
    for (std::size_t index = 0; index < traced.primitives.triangles.size(); ++index) {
        const std::array<Vertex, 3> &vertices = traced.primitives.triangles[index].vertices;
        const bool isNamed = index == current && index < traced.trace->primitiveCount();
        const SetUpRecord setUp = isNamed ? traced.trace->setUp(index) : SetUpRecord{};
        frame.drawOutline({vertices[0].position, vertices[1].position, vertices[2].position},
                          isNamed ? rolesOf(setUp) : EdgeRoles{});
        QPointF inside;
        for (const Vertex &vertex : vertices) {
            if (traced.indexInScene(index))
                frame.drawHandle(vertex.position, vertex.colour, HandleState::Idle);
            inside += mapping.positionOf(vertex.position) / 3;
        }
        for (std::size_t rank = 0; isNamed && rank < 3; ++rank)
            frame.drawVertexName(u"P%1"_s.arg(rank),
                                 vertices[std::size_t(setUp.order[rank])].position, inside);
    }
    painter.setBrush(Qt::NoBrush);
}

void drawShapes(FramePainter &frame, const Playhead &playhead, const ViewMapping &mapping)
{
    const Primitives &primitives = playhead.traced()->primitives;
    const std::optional<TraceStep> step = playhead.currentStep();
    for (std::size_t index = 0; index < primitives.shapes.size(); ++index) {
        const std::vector<Vertex> &vertices = primitives.shapes[index].vertices;
        frame.drawShapeOutline(primitives.shapes[index]);
        QPointF inside;
        for (const Vertex &vertex : vertices) {
            frame.drawHandle(vertex.position, vertex.colour, HandleState::Idle);
            inside += mapping.positionOf(vertex.position) / double(vertices.size());
        }
        const bool isNamed = primitives.triangles.size() + index == (step ? step->primitive : 0);
        for (std::size_t i = 0; isNamed && i < std::min(vertices.size(), mostVertexNames); ++i)
            frame.drawVertexName(u"P%1"_s.arg(i), vertices[i].position, inside);
    }
}

bool isTruthShown(const Playhead &playhead, const DisplayOptions &options)
{
    return options.isTruthShown() && !playhead.isAheadHidden();
}

LayerDrawing layersOf(const Playhead &playhead, const DisplayOptions &options,
                      const ViewMapping &mapping)
{
    const TracedScene &traced = *playhead.traced();
    if (isTruthShown(playhead, options))
        return {};
    return drawingOf(options.layers(),
                     {&traced, playhead.position(), samplesOf(windowOf(traced.scene.frame)),
                      cellSideOf(mapping), std::nullopt, playhead.pickedPixel(),
                      options.affineImage(), playhead.ahead()});
}

} // namespace

QByteArray svgFigure(const Playhead &playhead, const DisplayOptions &options,
                     const QString &caption)
{
    const TracedScene &traced = *playhead.traced();
    const QPalette palette = paperPalette();
    QFont font = QGuiApplication::font();
    font.setPixelSize(fontSize); // points would depend on the screen
    const Layout layout = layOut(traced.scene.frame, QFontMetricsF(font),
                                 options.layers().isEmpty() ? cellSize : numberCellSize);

    QByteArray svg;
    QBuffer buffer(&svg);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(layout.size);
    generator.setViewBox(QRect(QPoint(0, 0), layout.size));
    generator.setTitle(u"Pixelplumb"_s);
    generator.setDescription(caption);
    QPainter painter(&generator);
    painter.setFont(font);
    painter.fillRect(QRect(QPoint(0, 0), layout.size), Qt::white);
    const FrameBuffer &shown = isTruthShown(playhead, options) ? traced.truth : *playhead.frame();
    drawCells(painter, shown.image(), layout.mapping);

    FramePainter frame(painter, layout.mapping, palette, layout.view);
    frame.drawFrameEdge();
    if (options.isGridShown())
        frame.drawGrid();
    const LayerDrawing drawing = layersOf(playhead, options, layout.mapping);
    const LayerSurface surface = layerSurface(layout.mapping, layout.view, palette);
    LayerPainter layers;
    QStringList said = drawing.notes;
    if (!caption.isEmpty())
        said.prepend(caption);
    layers.paintGround(painter, drawing, surface);
    drawTriangles(painter, frame, playhead, layout.mapping);
    drawShapes(frame, playhead, layout.mapping);
    if (options.areDifferencesShown() && !isTruthShown(playhead, options))
        drawDifferences(painter, traced, playhead.position(), layout.mapping, palette);
    std::vector<RulerMark> columnMarks;
    std::vector<RulerMark> rowMarks;
    const std::optional<std::size_t> span = playhead.currentSpan();
    const SpanRecord record = span ? traced.trace->span(*span) : SpanRecord();
    if (span)
        frame.drawPlumbLine(record.place);
    said += layers.paintNumbers(painter, drawing, surface);
    layers.paintMarks(painter, drawing, surface);
    if (span) {
        frame.drawEdgeTicks(record);
        const RulerMark mark{double(record.place.coordinate), Sign::CurrentColumn};
        if (record.place.axis == SpanAxis::Column)
            columnMarks.push_back(mark);
        else if (record.place.axis == SpanAxis::Row)
            rowMarks.push_back(mark);
    }
    if (!said.isEmpty())
        frame.drawCornerNote(said.join(u'\n'), LayerPainter::figurePlaces(drawing, surface));
    const QStringList omissions = layers.paintLabels(painter, drawing, surface, frame.plates());
    if (!omissions.isEmpty())
        frame.drawCornerNote(omissions.join(u'\n'), layers.labels());
    Ruler(Qt::Horizontal, layout.columnRuler, layout.mapping).paint(painter, palette, columnMarks);
    Ruler(Qt::Vertical, layout.rowRuler, layout.mapping).paint(painter, palette, rowMarks);
    painter.end();
    return svg;
}

QString exportSvg(const QString &path, const Playhead &playhead, const DisplayOptions &options,
                  const QString &caption)
{
    if (!playhead.traced())
        return QCoreApplication::translate("pixelplumb::SvgExport",
                                           "There is nothing drawn yet to export.");
    const FrameSpec &frame = playhead.traced()->scene.frame;
    if (std::int64_t(frame.width) * frame.height > largestSvgArea)
        return QCoreApplication::translate("pixelplumb::SvgExport",
                                           "A frame of %1 × %2 pixels is too large for a figure of "
                                           "cells, which holds at most "
                                           "%3 of them. Export a PNG, or make the frame smaller.")
            .arg(frame.width)
            .arg(frame.height)
            .arg(largestSvgArea);
    const std::optional<InputError> error = writeFile(path, svgFigure(playhead, options, caption));
    return error ? error->message() : QString();
}

} // namespace pixelplumb
