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

#include <QPainter>

#include <algorithm>
#include <numeric>

namespace pixelplumb {

namespace {

constexpr std::size_t mostNames = 12; // more would hide what they name

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
    paintShapes(frame);
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
    if (!traced || index >= traced->trace->primitiveCount()
        || traced->scene.triangles[index] != m_document->scene().triangles[index])
        return std::nullopt;
    return traced->trace->setUp(index);
}

/// The primitive whose vertices have names: of the selected vertex, else the one in hand.
std::optional<int> Canvas::namedPrimitive() const
{
    const int count = m_document->primitiveCount();
    if (const std::optional<VertexRef> ref = m_document->selectedVertex();
        ref && ref->primitive != VertexRef::pending)
        return ref->primitive;
    if (count == 1)
        return 0;
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    return step && int(step->primitive) < count ? std::optional(int(step->primitive))
                                                : std::nullopt;
}

void Canvas::paintTriangles(FramePainter &frame)
{
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    const std::vector<Triangle> &triangles = m_document->scene().triangles;
    for (int index = 0; index < int(triangles.size()); ++index) {
        std::array<LatticePoint, 3> corners = cornersOf(triangles[std::size_t(index)]);
        for (LatticePoint &corner : corners)
            corner = onSamples(corner);
        const bool isInHand = step && step->primitive == std::size_t(index);
        const std::optional<SetUpRecord> setUp = isInHand ? setUpOf(index) : std::nullopt;
        frame.drawOutline(corners, setUp ? rolesOf(*setUp) : EdgeRoles{});
    }
}

void Canvas::paintShapes(FramePainter &frame)
{
    for (Shape shape : m_document->scene().shapes) {
        for (Vertex &vertex : shape.vertices)
            vertex.position = onSamples(vertex.position);
        frame.drawShapeOutline(shape);
    }
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

    if (const std::optional<int> named = namedPrimitive())
        paintNamesOf(*named, frame);
}

/// P0, P1, P2 of a triangle in the order in which the method sorts them, of a shape as they stand.
void Canvas::paintNamesOf(int primitive, FramePainter &frame)
{
    const std::vector<Vertex> vertices = m_document->verticesOf(primitive);
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (m_document->kindOf(primitive) == PrimitiveKind::Triangle) {
        const std::optional<SetUpRecord> setUp = setUpOf(primitive);
        const std::array<int, 3> sorted = setUp
            ? setUp->order
            : sortedByColumn(m_document->scene().triangles[std::size_t(primitive)]);
        std::ranges::copy(sorted, order.begin());
    }
    QPointF inside;
    for (const Vertex &vertex : vertices)
        inside += positionOf(vertex.position) / double(vertices.size());
    for (std::size_t rank = 0; rank < std::min(order.size(), mostNames); ++rank)
        frame.drawVertexName(QStringLiteral("P%1").arg(rank),
                             onSamples(vertices[order[rank]].position), inside);
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
