// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"
#include "widgets/canvaspicture.h"
#include "widgets/displayoptions.h"
#include "widgets/framepainter.h"
#include "widgets/numberformat.h"
#include "widgets/playhead.h"
#include "widgets/ruler.h"

#include <QPainter>

namespace pixelplumb {

namespace {

std::array<LatticePoint, 3> cornersOf(const Triangle &triangle)
{
    return {triangle.vertices[0].position, triangle.vertices[1].position,
            triangle.vertices[2].position};
}

QString coordinateNote(const LatticePoint &point)
{
    return QStringLiteral("(%1, %2)")
        .arg(displayText(Quantity::rational(point.x, unitsPerPixel)),
             displayText(Quantity::rational(point.y, unitsPerPixel)));
}

} // namespace

void Canvas::paintEvent(QPaintEvent *)
{
    followDevice();
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const QRectF frameView = view();
    painter.setClipRect(frameView);
    painter.fillRect(frameView, palette().color(QPalette::Mid));
    paintCells(painter);

    FramePainter frame(painter, m_mapping, palette(), frameView);
    frame.drawFrameEdge();
    paintTriangles(frame);
    if (tracedOfFrame() && m_options->areDifferencesShown() && !isTruthVisible())
        m_differences.drawGlyphs(painter, m_playhead->position(), palette());
    paintSigns(frame);
    paintVertexNames(frame);
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
    if (device.isEmpty())
        return;
    const double ratio = m_mapping.devicePixelRatio();
    const QRectF target(m_mapping.positionOfDevice(device.topLeft()),
                        QSizeF(device.size()) / ratio);
    const TracedScene *traced = tracedOfFrame();
    if (!traced) {
        painter.fillRect(target, QColor::fromRgb(packed(m_mapping.frame().background)));
        return;
    }
    const FrameBuffer &frame = isTruthVisible() ? traced->truth : *m_playhead->frame();
    m_cells.setDevicePixelRatio(1);
    enlargePicture(frame.image(), m_mapping, device, m_cells);
    if (m_options->isGridShown())
        blendGrid(m_cells, m_mapping, device, gridColour(m_mapping));
    if (m_options->areDifferencesShown() && !isTruthVisible()) {
        m_differences.lookUp(m_playhead->sharedTraced(), m_mapping, device);
        m_differences.markCells(m_cells, m_playhead->position(), palette());
    }
    m_cells.setDevicePixelRatio(ratio);
    painter.drawImage(target.topLeft(), m_cells);
}

LatticePoint Canvas::onSamples(const LatticePoint &scenePoint) const
{
    const Lattice offset = sampleOffset(m_mapping.frame());
    return {scenePoint.x - offset, scenePoint.y - offset};
}

std::optional<SetUpRecord> Canvas::setUpOf(int triangle) const
{
    const TracedScene *traced = tracedOfFrame();
    const auto index = std::size_t(triangle);
    // A drag may be ahead of the trace: numbers of a triangle that was there before are not shown.
    if (!traced || index >= traced->trace->triangleCount()
        || traced->scene.triangles[index] != m_document->scene().triangles[index])
        return std::nullopt;
    return traced->trace->setUp(index);
}

/// The triangle whose vertices have names: of the selected vertex, else the one in hand.
std::optional<int> Canvas::namedTriangle() const
{
    const std::size_t count = m_document->scene().triangles.size();
    if (const std::optional<VertexRef> ref = m_document->selectedVertex();
        ref && ref->triangle != VertexRef::pending)
        return ref->triangle;
    if (count == 1)
        return 0;
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    return step && step->triangle < count ? std::optional(int(step->triangle)) : std::nullopt;
}

void Canvas::paintTriangles(FramePainter &frame)
{
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    const std::vector<Triangle> &triangles = m_document->scene().triangles;
    for (int index = 0; index < int(triangles.size()); ++index) {
        std::array<LatticePoint, 3> corners = cornersOf(triangles[std::size_t(index)]);
        for (LatticePoint &corner : corners)
            corner = onSamples(corner);
        const bool isInHand = step && step->triangle == std::size_t(index);
        const std::optional<SetUpRecord> setUp = isInHand ? setUpOf(index) : std::nullopt;
        frame.drawOutline(corners, setUp ? rolesOf(*setUp) : EdgeRoles{});
    }
}

void Canvas::paintSigns(FramePainter &frame)
{
    for (const auto &[x, y] : m_playhead->pixelBreakpoints())
        frame.drawPixelBreakpoint({x, y});
    if (const std::optional<QPoint> pixel = m_playhead->pickedPixel())
        frame.drawPickedPixel(*pixel);
    const std::optional<std::size_t> column = m_playhead->columnInHand();
    if (!column || !tracedOfFrame())
        return;
    const ColumnRecord record = m_playhead->traced()->trace->column(*column);
    frame.drawPlumbLine(record.x);
    frame.drawEdgeTicks(record);
}

void Canvas::paintVertexNames(FramePainter &frame)
{
    const std::optional<VertexRef> hoveredVertex
        = m_hover && !m_gesture ? vertexAt(*m_hover) : std::nullopt;
    for (const VertexRef &ref : m_document->vertices()) {
        const Vertex vertex = *m_document->vertexAt(ref);
        HandleState state = HandleState::Idle;
        if (ref == m_document->selectedVertex())
            state = HandleState::Selected;
        else if (ref == hoveredVertex)
            state = HandleState::Hovered;
        frame.drawHandle(onSamples(vertex.position), vertex.colour, state);
    }

    const std::optional<int> named = namedTriangle();
    if (!named)
        return;
    const Triangle &triangle = m_document->scene().triangles[std::size_t(*named)];
    const std::optional<SetUpRecord> setUp = setUpOf(*named);
    const std::array<int, 3> order = setUp ? setUp->order : sortedByColumn(triangle);
    QPointF inside;
    for (const Vertex &vertex : triangle.vertices)
        inside += positionOf(vertex.position) / 3;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const Vertex &vertex = triangle.vertices[std::size_t(order[rank])];
        frame.drawVertexName(QStringLiteral("P%1").arg(rank), onSamples(vertex.position), inside);
    }
}

/// The vertex that a click or Enter would place now, in the scene's coordinates.
std::optional<LatticePoint> Canvas::candidate() const
{
    const bool placing = !m_gesture || dynamic_cast<const PlaceVertexGesture *>(m_gesture.get());
    if (m_hover && placing && view().contains(*m_hover) && (m_gesture || !vertexAt(*m_hover)))
        return placeAt(*m_hover);
    const std::optional<QPoint> picked = m_playhead->pickedPixel();
    if (m_hover || !hasFocus() || !picked || m_document->pendingVertices().empty())
        return std::nullopt;
    const Lattice offset = sampleOffset(m_mapping.frame());
    const LatticePoint sample = latticePixel(picked->x(), picked->y());
    return LatticePoint{sample.x + offset, sample.y + offset};
}

void Canvas::paintPending(FramePainter &frame)
{
    const std::optional<LatticePoint> next = candidate();
    if (!next)
        return;
    const std::vector<Vertex> &pending = m_document->pendingVertices();
    const LatticePoint tip = onSamples(*next);
    if (pending.size() == 2) {
        const LatticePoint first = onSamples(pending[0].position);
        const LatticePoint second = onSamples(pending[1].position);
        frame.drawRubberLine(first, second);
        frame.drawRubberLine(second, tip);
        frame.drawRubberLine(tip, first);
    } else if (pending.size() == 1) {
        frame.drawRubberLine(onSamples(pending[0].position), tip);
    }
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
    switch (m_document->pendingVertices().size()) {
    case 2:
        return tr("Click the third point");
    case 1:
        return tr("Click the second point");
    default:
        break;
    }
    return m_document->scene().triangles.empty() ? tr("Click three points to draw a triangle")
                                                 : QString();
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
    if (const std::optional<std::int64_t> x = m_playhead->columnXInHand())
        columnMarks.push_back({double(*x), Sign::ColumnInHand});
    Ruler(Qt::Horizontal, columnRuler(), m_mapping).paint(painter, palette(), columnMarks);
    Ruler(Qt::Vertical, rowRuler(), m_mapping).paint(painter, palette(), rowMarks);
    const QRectF corner(0, columnRuler().top(), rowRuler().width(), columnRuler().height());
    painter.fillRect(corner, palette().color(QPalette::Window));
}

} // namespace pixelplumb
