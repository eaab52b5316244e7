// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvaspainter.h"

#include "core/layers/layer.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/cellvalues.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/framepainter.h"
#include "widgets/model/playhead.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace pixelplumb {

namespace {

/// The pixels whose cells meet the area, inside the frame or not.
SampleBox pixelsIn(const QRectF &area, const ViewMapping &mapping)
{
    const auto [left, right]
        = std::minmax({mapping.columnAt(area.topLeft()), mapping.columnAt(area.bottomRight())});
    const auto [low, high]
        = std::minmax({mapping.rowAt(area.topLeft()), mapping.rowAt(area.bottomRight())});
    return {left, right + 1, low, high + 1};
}

constexpr int mostValues = 2'500; ///< cells; drawing more would delay the pointer

/// Fills the part of a rectangle around another one that will be painted over: filling that too
/// would take as long as painting it.
void fillAround(QPainter &painter, const QRect &rect, const QRectF &covered, const QColor &colour)
{
    const QRect surelyCovered = covered.toRect().adjusted(1, 1, -1, -1);
    for (const QRect &part : QRegion(rect) - surelyCovered)
        painter.fillRect(part, colour);
}

void drawOutlines(FramePainter &frame, const CanvasScene &scene)
{
    for (const CanvasScene::Outline &outline : scene.outlines)
        frame.drawOutline(outline.corners, outline.roles);
    for (const Shape &shape : scene.shapes)
        frame.drawShapeOutline(shape);
    frame.drawClippedPolygon(scene.clippedPolygon);
}

void drawSigns(FramePainter &frame, const CanvasScene &scene)
{
    for (const QPoint &pixel : scene.breakpoints)
        frame.drawPixelBreakpoint(pixel);
    if (scene.offScreenPoint)
        frame.drawOffScreenPoint(*scene.offScreenPoint);
    if (scene.picked)
        frame.drawPickedPixel(*scene.picked);
    if (scene.span)
        frame.drawPlumbLine(scene.span->place);
}

void drawHandles(FramePainter &frame, const CanvasScene &scene)
{
    for (const CanvasScene::Handle &handle : scene.handles)
        frame.drawHandle(handle.point, handle.colour, handle.state);
}

void drawNames(FramePainter &frame, const CanvasScene &scene)
{
    for (const CanvasScene::VertexName &name : scene.names)
        frame.drawVertexName(name.name, name.point, name.inside);
}

void drawPending(FramePainter &frame, const CanvasScene &scene)
{
    frame.drawRubberPath(scene.rubberPath);
    if (scene.rubberShape)
        frame.drawShapeOutline(*scene.rubberShape);
    for (const CanvasScene::Handle &handle : scene.pending)
        frame.drawHandle(handle.point, handle.colour, handle.state);
    if (scene.candidate)
        frame.drawCandidate(scene.candidate->point, scene.candidate->colour);
}

void paintRulers(QPainter &painter, const CanvasScene &scene, const CanvasView &view,
                 const QPalette &palette)
{
    const QRectF columns = view.columnRuler();
    const QRectF rows = view.rowRuler();
    Ruler(Qt::Horizontal, columns, view.mapping()).paint(painter, palette, scene.columnMarks);
    Ruler(Qt::Vertical, rows, view.mapping()).paint(painter, palette, scene.rowMarks);
    const QRectF corner(0, columns.top(), rows.width(), columns.height());
    painter.fillRect(corner, palette.color(QPalette::Window));
}

} // namespace

void CanvasLayers::addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view)
{
    if (sources.options->layers().isEmpty() || !runInView(sources)) {
        *this = {};
        return;
    }
    const Moment moment = {sources.playhead->sharedTraced(),
                           sources.playhead->position(),
                           sources.options->layers(),
                           view.mapping(),
                           view.area(),
                           sources.playhead->pickedPixel(),
                           sources.options->affineImage(),
                           sources.playhead->ahead()};
    if (moment != m_moment) {
        m_moment = moment;
        m_drawing = drawingOf(moment.layers,
                              {moment.traced.get(), moment.position,
                               pixelsIn(moment.area, moment.mapping), cellSideOf(moment.mapping),
                               std::nullopt, moment.picked, moment.image, moment.ahead});
    }
    scene.layers = m_drawing;
}

void enlargePicture(const QImage &picture, const ViewMapping &mapping, const QRect &device,
                    QImage &shown)
{
    Q_ASSERT(mapping.devicePicture().contains(device));
    if (shown.size() != device.size())
        shown = QImage(device.size(), QImage::Format_RGB32);

    std::vector<int> columns(std::size_t(device.width()));
    for (int x = 0; x < device.width(); ++x)
        columns[std::size_t(x)] = mapping.pictureColumnAt(device.left() + x);

    const bool isCopied = mapping.zoom() == ViewZoom{1, 1};
    int previousLine = -1;
    for (int y = 0; y < device.height(); ++y) {
        const int line = mapping.pictureLineAt(device.top() + y);
        uchar *const target = shown.scanLine(y);
        if (line == previousLine) {
            std::memcpy(target, shown.constScanLine(y - 1), std::size_t(shown.bytesPerLine()));
            continue;
        }
        const auto *const source = reinterpret_cast<const QRgb *>(picture.constScanLine(line));
        if (isCopied) {
            std::memcpy(target, source + columns[0], std::size_t(device.width()) * sizeof(QRgb));
            continue;
        }
        auto *const pixels = reinterpret_cast<QRgb *>(target);
        for (int x = 0; x < device.width(); ++x)
            pixels[x] = source[columns[std::size_t(x)]];
        previousLine = line;
    }
}

void drawValues(QPainter &painter, const FrameBuffer &frame, const ViewMapping &mapping,
                const QRectF &area, ByteNotation notation)
{
    const CellValueStyle style{painter.font(), notation};
    if (mapping.zoom().factor() / mapping.devicePixelRatio() < leastReadableCell(style))
        return;
    const QRect part = mapping.pictureIn(mapping.deviceRect(area) & mapping.devicePicture());
    if (part.width() * part.height() > mostValues)
        return;
    painter.save();
    forEachPixel(frame.spec(), part, [&](const QPoint &pixel) {
        const QRgb colour = *frame.view().at(pixel.x(), pixel.y());
        drawCellValues(painter, mapping.cellOf(pixel), colour, textColourOn(colour), style);
    });
    painter.restore();
}

void blendGrid(QImage &shown, const ViewMapping &mapping, const QRect &device, const QColor &colour)
{
    const int cell = mapping.zoom().devicePixels;
    if (colour.alpha() == 0 || cell < 2)
        return;
    // One tiled fill costs a fraction of hundreds of thin translucent rectangles.
    QImage tile(cell, cell, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    QPainter lines(&tile);
    lines.fillRect(0, 0, cell, 1, colour);
    lines.fillRect(0, 1, 1, cell - 1, colour);
    lines.end();
    QPainter painter(&shown);
    painter.setBrushOrigin(mapping.origin() - device.topLeft());
    painter.fillRect(shown.rect(), QBrush(tile));
}

void CanvasPainter::paint(QPainter &painter, const CanvasScene &scene, const CanvasView &view,
                          const QPalette &palette)
{
    const QRectF area = view.area();
    fillAround(painter, view.bounds(), area, palette.color(QPalette::Window));
    painter.setClipRect(area);
    paintCells(painter, scene, view, palette);
    FramePainter frame(painter, view.mapping(), palette, area);
    frame.drawFrameEdge();
    const LayerSurface surface = layerSurface(view.mapping(), area, palette);
    QStringList said = scene.layers.notes;
    m_layers.paintGround(painter, scene.layers, surface);
    drawOutlines(frame, scene);
    drawSigns(frame, scene);
    drawHandles(frame, scene);
    // Over lines, frames and handles, so that every digit is readable; not where a layer has
    // numbers or dots in the cells.
    said += m_layers.paintNumbers(painter, scene.layers, surface);
    if (scene.frame && scene.layers.cells.empty() && scene.layers.samples.empty())
        drawValues(painter, *scene.frame, view.mapping(), area, scene.notation);
    if (scene.marked)
        m_differences.drawGlyphs(painter, scene.position, palette);
    m_layers.paintMarks(painter, scene.layers, surface);
    if (scene.span)
        frame.drawEdgeTicks(*scene.span);
    drawPending(frame, scene);
    for (const CanvasScene::Note &note : scene.notes)
        frame.drawNote(note.text, note.anchor, note.side);
    drawNames(frame, scene); // after the notes, which they avoid
    if (!said.isEmpty())
        frame.drawCornerNote(said.join(u'\n'), LayerPainter::figurePlaces(scene.layers, surface));
    // Last, so that they avoid everything that has a name of its own.
    const QStringList omissions
        = m_layers.paintLabels(painter, scene.layers, surface, frame.plates());
    if (!omissions.isEmpty())
        frame.drawCornerNote(omissions.join(u'\n'), m_layers.labels());
    if (scene.readout)
        frame.drawPointerNote(scene.readout->text, scene.readout->pointer, m_layers.labels());
    painter.setClipping(false);
    paintRulers(painter, scene, view, palette);
}

void CanvasPainter::paintCells(QPainter &painter, const CanvasScene &scene, const CanvasView &view,
                               const QPalette &palette)
{
    const ViewMapping &mapping = view.mapping();
    const QRect device = mapping.deviceRect(view.area()) & mapping.devicePicture();
    const double ratio = mapping.devicePixelRatio();
    const QRectF target(mapping.positionOfDevice(device.topLeft()), QSizeF(device.size()) / ratio);
    fillAround(painter, view.area().toAlignedRect(), target, palette.color(QPalette::Mid));
    if (device.isEmpty())
        return;
    if (!scene.frame) {
        m_differences.forget();
        painter.fillRect(target, QColor::fromRgb(packed(mapping.frame().background)));
        return;
    }
    QImage shown = cellsOf(scene, mapping, device, palette);
    shown.setDevicePixelRatio(ratio);
    painter.drawImage(target.topLeft(), shown);
}

/// The cells in a rectangle of device pixels, with the grid lines and the signs in them.
QImage CanvasPainter::cellsOf(const CanvasScene &scene, const ViewMapping &mapping,
                              const QRect &device, const QPalette &palette)
{
    const bool isGridShown
        = scene.grid == CanvasScene::Grid::Shown && gridColour(mapping).alpha() > 0;
    if (scene.marked)
        m_differences.lookUp(*scene.marked, mapping, device);
    const bool isAsItIs = mapping.zoom() == ViewZoom{1, 1} && !isGridShown;
    if (isAsItIs && (!scene.marked || !m_differences.hasMarks())) {
        const QRect part = mapping.pictureIn(device);
        const QImage whole = scene.frame->image();
        return QImage(whole.constScanLine(part.top()) + part.left() * qsizetype(sizeof(QRgb)),
                      part.width(), part.height(), whole.bytesPerLine(), whole.format());
    }
    m_cells.setDevicePixelRatio(1);
    enlargePicture(scene.frame->image(), mapping, device, m_cells);
    if (isGridShown)
        blendGrid(m_cells, mapping, device, gridColour(mapping));
    if (scene.marked)
        m_differences.markCells(m_cells, scene.position, palette);
    return m_cells;
}

} // namespace pixelplumb
