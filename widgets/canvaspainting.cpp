// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapeediting.h"
#include "widgets/canvas.h"
#include "widgets/canvaspicture.h"
#include "widgets/displayoptions.h"
#include "widgets/framepainter.h"
#include "widgets/numberformat.h"
#include "widgets/placinghint.h"
#include "widgets/playhead.h"
#include "widgets/ruler.h"
#include "widgets/scenepreviewer.h"

#include <QPainter>

namespace pixelplumb {

namespace {

QString coordinateNote(const LatticePoint &point)
{
    return QStringLiteral("(%1, %2)")
        .arg(displayText(Quantity::rational(point.x, unitsPerPixel)),
             displayText(Quantity::rational(point.y, unitsPerPixel)));
}

/// Fills what of a rectangle lies around another, which is going to be painted over: filling that
/// too takes as long as painting it.
void fillAround(QPainter &painter, const QRect &rect, const QRectF &covered, const QColor &colour)
{
    const QRect surelyCovered = covered.toRect().adjusted(1, 1, -1, -1);
    for (const QRect &part : QRegion(rect) - surelyCovered)
        painter.fillRect(part, colour);
}

} // namespace

void Canvas::paintEvent(QPaintEvent *)
{
    followDevice();
    QPainter painter(this);
    m_repaintTimer.stop();
    const QRectF frameView = view();
    fillAround(painter, rect(), frameView, palette().color(QPalette::Window));
    painter.setClipRect(frameView);
    paintCells(painter);

    FramePainter frame(painter, m_mapping, palette(), frameView);
    frame.drawFrameEdge();
    paintOutlines(frame);
    if (m_options->areDifferencesShown() && !isTruthVisible())
        m_differences.drawGlyphs(painter, m_playhead->position(), palette());
    paintSigns(frame);
    paintHandles(frame);
    paintPending(frame);
    paintNotes(frame);
    painter.setClipping(false);
    paintRulers(painter);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(frameView.adjusted(0, 0, -1, -1));
    }
}

void Canvas::paintCells(QPainter &painter)
{
    const QRect device = m_mapping.deviceRect(view()) & m_mapping.devicePicture();
    const double ratio = m_mapping.devicePixelRatio();
    const QRectF target(m_mapping.positionOfDevice(device.topLeft()),
                        QSizeF(device.size()) / ratio);
    fillAround(painter, view().toAlignedRect(), target, palette().color(QPalette::Mid));
    if (device.isEmpty())
        return;
    const FrameBuffer *frame = shownFrame();
    if (!frame) {
        m_differences.forget();
        painter.fillRect(target, QColor::fromRgb(packed(m_mapping.frame().background)));
        return;
    }
    QImage shown = cellsOf(*frame, device);
    shown.setDevicePixelRatio(ratio);
    painter.drawImage(target.topLeft(), shown);
}

/// The cells in a rectangle of device pixels, with the lines between them and the signs in them.
QImage Canvas::cellsOf(const FrameBuffer &frame, const QRect &device)
{
    const bool isGridShown = m_options->isGridShown() && gridColour(m_mapping).alpha() > 0;
    const bool areMarked = m_options->areDifferencesShown() && !isTruthVisible();
    if (areMarked && shownPreview())
        m_differences.lookUp(m_previewer->picture(), m_mapping, device);
    else if (areMarked)
        m_differences.lookUp(m_playhead->sharedTraced(), m_mapping, device);
    const bool isAsItIs = m_mapping.zoom() == ViewZoom{1, 1} && !isGridShown;
    if (isAsItIs && (!areMarked || !m_differences.hasMarks())) {
        const QRect part = m_mapping.pictureIn(device);
        const QImage whole = frame.image();
        return QImage(whole.constScanLine(part.top()) + part.left() * qsizetype(sizeof(QRgb)),
                      part.width(), part.height(), whole.bytesPerLine(), whole.format());
    }
    m_cells.setDevicePixelRatio(1);
    enlargePicture(frame.image(), m_mapping, device, m_cells);
    if (isGridShown)
        blendGrid(m_cells, m_mapping, device, gridColour(m_mapping));
    if (areMarked)
        m_differences.markCells(m_cells, m_playhead->position(), palette());
    return m_cells;
}

/// The picture that stands for the run: while the run of the present scene is not there, and at
/// the end of one that was cut.
const ScenePicture *Canvas::shownPreview() const
{
    const ScenePicture *picture = m_previewer ? m_previewer->picture().get() : nullptr;
    if (!picture || picture->spec() != m_mapping.frame())
        return nullptr;
    const bool isAtEnd = m_playhead->position() == m_playhead->end();
    return m_previewer->isAheadOfTrace() || isAtEnd ? picture : nullptr;
}

const FrameBuffer *Canvas::shownFrame() const
{
    const ScenePicture *preview = shownPreview();
    const TracedScene *traced = tracedOfFrame();
    if (isTruthVisible()) {
        if (preview && preview->truth())
            return preview->truth();
        return traced ? &traced->truth : nullptr;
    }
    if (preview)
        return &preview->drawn();
    return traced ? m_playhead->frame() : nullptr;
}

LatticePoint Canvas::onSamples(const LatticePoint &scenePoint) const
{
    const Lattice offset = sampleOffset(m_mapping.frame());
    return {scenePoint.x - offset, scenePoint.y - offset};
}

void Canvas::paintSigns(FramePainter &frame)
{
    for (const auto &[x, y] : m_playhead->pixelBreakpoints())
        frame.drawPixelBreakpoint({x, y});
    if (const std::optional<QPoint> pixel = m_playhead->pickedPixel())
        frame.drawPickedPixel(*pixel);
    const std::optional<std::size_t> span = m_playhead->spanInHand();
    if (!span || !tracedOfFrame())
        return;
    const SpanRecord record = m_playhead->traced()->trace->span(*span);
    frame.drawPlumbLine(record.place);
    frame.drawEdgeTicks(record);
}

/// The vertex that a click or Enter would place now, in the scene's coordinates.
std::optional<LatticePoint> Canvas::candidate()
{
    const bool placing = !m_gesture || dynamic_cast<const PlaceVertexGesture *>(m_gesture.get());
    if (m_hover && placing && view().contains(*m_hover) && (m_gesture || !hoveredVertex()))
        return placeAt(*m_hover);
    const std::optional<QPoint> picked = m_playhead->pickedPixel();
    if (m_hover || !hasFocus() || !picked || m_document->pendingVertices().empty())
        return std::nullopt;
    const Lattice offset = sampleOffset(m_mapping.frame());
    const LatticePoint sample = latticePixel(picked->x(), picked->y());
    return LatticePoint{sample.x + offset, sample.y + offset};
}

/// What the pending vertices and the tip would make.
void Canvas::paintRubber(FramePainter &frame, const LatticePoint &tip)
{
    const PrimitiveKind kind = m_document->placedKind();
    std::vector<Vertex> vertices;
    std::vector<LatticePoint> path;
    for (const Vertex &vertex : m_document->pendingVertices()) {
        vertices.push_back({onSamples(vertex.position), vertex.colour});
        path.push_back(vertices.back().position);
    }
    if (vertices.empty())
        return;
    vertices.push_back({tip, m_document->nextColour()});
    path.push_back(tip);
    const bool closes = kind == PrimitiveKind::Triangle || kind == PrimitiveKind::Polygon;
    if (closes && path.size() > 2)
        path.push_back(path.front());
    if (!closes && placedVertexCount(kind) == vertices.size())
        frame.drawShapeOutline(shapeFrom(kind, vertices));
    else
        frame.drawRubberPath(path);
}

void Canvas::paintPending(FramePainter &frame)
{
    const std::optional<LatticePoint> next = candidate();
    if (!next)
        return;
    const std::vector<Vertex> &pending = m_document->pendingVertices();
    const LatticePoint tip = onSamples(*next);
    paintRubber(frame, tip);
    for (const Vertex &vertex : pending)
        frame.drawHandle(onSamples(vertex.position), vertex.colour, HandleState::Idle);
    frame.drawCandidate(tip, m_document->nextColour());
    if (!pending.empty() || m_gesture)
        frame.drawNote(coordinateNote(*next), m_mapping.positionOf(tip), NoteSide::BelowRight);
}

QString Canvas::hint() const
{
    if (isTruthVisible())
        return tr("Truth: the exact picture");
    return placingHint(m_document->placedKind(), m_document->pendingVertices().size(),
                       m_document->primitiveCount() == 0 ? FrameContent::Empty
                                                         : FrameContent::Drawn);
}

void Canvas::paintNotes(FramePainter &frame)
{
    const std::optional<VertexRef> ref = m_document->selectedVertex();
    const bool moving = m_keyDrag || dynamic_cast<const MoveVertexGesture *>(m_gesture.get());
    if (ref && moving) {
        const LatticePoint point = m_document->vertexAt(*ref)->position;
        frame.drawNote(coordinateNote(point), positionOf(point), NoteSide::BelowRight);
    }
    if (const QString text = hint(); !text.isEmpty())
        frame.drawNote(text, {view().center().x(), view().top()}, NoteSide::Below);
    if (const QString text = viewNote(); !text.isEmpty())
        frame.drawNote(text, {view().center().x(), view().bottom()}, NoteSide::Above);
}

/// Why the view does not show what it usually does.
QString Canvas::viewNote() const
{
    QStringList notes;
    if (shownPreview() && !isTruthVisible() && !m_previewer->isAheadOfTrace())
        notes += tr("Finished picture; the first %L1 steps are recorded").arg(m_playhead->end());
    if (m_outlines.isCrowded())
        notes += tr("Outlines and handles only under the pointer and in hand: over %1 in view")
                     .arg(OutlineChoice::mostInView);
    return notes.join(QStringLiteral(" · "));
}

void Canvas::paintRulers(QPainter &painter)
{
    std::vector<RulerMark> columnMarks;
    std::vector<RulerMark> rowMarks;
    for (const std::int64_t x : m_playhead->columnBreakpoints())
        columnMarks.push_back({double(x), Sign::Breakpoint});
    if (const std::optional<QPoint> pixel = m_playhead->pickedPixel()) {
        columnMarks.push_back({double(pixel->x()), Sign::PickedPixel});
        rowMarks.push_back({double(pixel->y()), Sign::PickedPixel});
    }
    for (const std::int64_t y : m_playhead->rowBreakpoints())
        rowMarks.push_back({double(y), Sign::Breakpoint});
    const std::optional<SpanPlace> place = m_playhead->placeInHand();
    if (place && place->axis == SpanAxis::Column)
        columnMarks.push_back({double(place->coordinate), Sign::ColumnInHand});
    if (place && place->axis == SpanAxis::Row)
        rowMarks.push_back({double(place->coordinate), Sign::ColumnInHand});
    Ruler(Qt::Horizontal, columnRuler(), m_mapping).paint(painter, palette(), columnMarks);
    Ruler(Qt::Vertical, rowRuler(), m_mapping).paint(painter, palette(), rowMarks);
    const QRectF corner(0, columnRuler().top(), rowRuler().width(), columnRuler().height());
    painter.fillRect(corner, palette().color(QPalette::Window));
}

} // namespace pixelplumb
