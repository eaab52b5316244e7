// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasmouse.h"

#include "widgets/canvas/canvas.h"
#include "widgets/canvas/canvasgesture.h"
#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/corewords.h"
#include "widgets/model/playhead.h"

#include <cstdlib>

namespace pixelplumb {

CanvasMouse::CanvasMouse(Canvas &canvas, CanvasView &view, const CanvasSources &sources)
    : m_canvas(canvas)
    , m_view(view)
    , m_sources(sources)
    , m_document(*sources.document)
    , m_playhead(*sources.playhead)
{
}

void CanvasMouse::press(QMouseEvent *event)
{
    hoverAt(event->position());
    if (m_gesture)
        return; // a second button during a gesture
    if (event->button() == Qt::RightButton) {
        pressRight(event->position());
        return;
    }
    m_pressedVertex = m_canvas.vertexAt(event->position());
    if (event->button() == Qt::LeftButton)
        chooseCorner(imageCornerAt(event->position(), m_sources, m_view));
    begin(event);
}

void CanvasMouse::begin(QMouseEvent *event)
{
    const QPointF position = event->position();
    const bool left = event->button() == Qt::LeftButton;
    const bool moveView = event->button() == Qt::MiddleButton
        || (left && event->modifiers().testFlag(Qt::ControlModifier));
    if (moveView) {
        m_gesture = std::make_unique<MoveViewGesture>(m_view, position);
    } else if (left && m_view.columnRuler().contains(position)) {
        m_gesture = std::make_unique<SeekColumnGesture>(m_view, m_playhead);
        m_gesture->moveTo(position);
    } else if (left && m_chosenCorner) {
        m_gesture = std::make_unique<MoveImageCornerGesture>(m_view, m_sources, *m_chosenCorner,
                                                             position);
    } else if (left && m_tool == CanvasTool::Draw) {
        m_gesture = drawingGesture(position);
    } else if (left && m_view.area().contains(position)) {
        m_gesture = std::make_unique<PickPixelGesture>(m_view, m_playhead);
        m_gesture->moveTo(position);
    }
    m_canvas.setCursor(cursor());
}

std::unique_ptr<CanvasGesture> CanvasMouse::drawingGesture(const QPointF &position)
{
    if (m_pressedVertex == VertexRef{VertexRef::pending, 0} && m_document.canClosePending()) {
        m_document.closePending();
        return nullptr;
    }
    if (m_pressedVertex)
        return std::make_unique<MoveVertexGesture>(m_view, m_document, *m_pressedVertex, position);
    if (isOffScreenPointAt(position, m_document, m_view))
        return std::make_unique<MoveOffScreenPointGesture>(m_view, m_document, position);
    if (!m_view.area().contains(position))
        return nullptr;
    m_document.selectVertex(std::nullopt);
    return std::make_unique<PlaceVertexGesture>(m_view, m_document);
}

void CanvasMouse::move(const QPointF &position)
{
    if (m_gesture)
        m_gesture->moveTo(position);
    hoverAt(position);
}

void CanvasMouse::release(QMouseEvent *event)
{
    const bool ends = m_gesture && event->button() != Qt::RightButton;
    hoverAt(event->position());
    if (!ends)
        return;
    m_gesture->releaseAt(event->position());
    end();
}

void CanvasMouse::end()
{
    m_gesture.reset();
    m_canvas.setCursor(cursor());
    m_canvas.update();
}

void CanvasMouse::cancelGesture()
{
    m_gesture->cancel();
    end();
}

void CanvasMouse::doubleClick(QMouseEvent *event)
{
    const QPointF position = event->position();
    const std::optional<VertexRef> ref = m_canvas.vertexAt(position);
    if (event->button() == Qt::LeftButton && m_view.columnRuler().contains(position)) {
        toggleBreakpointAt(position);
    } else if (event->button() == Qt::LeftButton && m_chosenCorner
               && m_chosenCorner == imageCornerAt(position, m_sources, m_view)) {
        if (m_sources.options->affineImage())
            m_document.undoStack()->push(new ImageEdit(*m_sources.options, std::nullopt));
    } else if (event->button() == Qt::LeftButton && ref && m_tool == CanvasTool::Draw) {
        if (ref == m_pressedVertex) // else the first click placed the vertex
            emit m_canvas.colourRequested(*ref);
    } else {
        press(event); // two quick clicks at two places
    }
}

void CanvasMouse::pressRight(const QPointF &position)
{
    if (m_view.columnRuler().contains(position)) {
        toggleBreakpointAt(position);
    } else if (const std::optional<VertexRef> ref = m_canvas.vertexAt(position)) {
        m_document.selectVertex(ref);
        openVertexMenu(*ref, position);
    } else if (const std::optional<QPoint> pixel = m_view.pixelAt(position)) {
        m_playhead.pick(*pixel);
    }
}

void CanvasMouse::openVertexMenu(const VertexRef &ref, const QPointF &position)
{
    auto *menu = new CanvasMenu(&m_document, ref, &m_canvas);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(menu, &CanvasMenu::colourRequested, &m_canvas, &Canvas::colourRequested);
    QObject::connect(menu, &CanvasMenu::coordinatesRequested, &m_canvas, &Canvas::editCoordinates);
    menu->popup(m_canvas.mapToGlobal(position.toPoint()));
}

void CanvasMouse::toggleBreakpointAt(const QPointF &position)
{
    m_playhead.toggleSpanBreakpoint({SpanAxis::Column, m_view.mapping().columnAt(position), 0});
}

void CanvasMouse::turn(QWheelEvent *event)
{
    event->accept();
    m_wheelRest += event->angleDelta().y();
    const int notches = m_wheelRest / QWheelEvent::DefaultDeltasPerStep;
    m_wheelRest -= notches * QWheelEvent::DefaultDeltasPerStep;
    for (int notch = 0; notch < std::abs(notches); ++notch) {
        const ViewZoom &zoom = m_view.mapping().zoom();
        m_view.zoomTo(notches > 0 ? zoom.nextLarger() : zoom.nextSmaller(), event->position());
    }
    hoverAt(event->position());
}

void CanvasMouse::hoverAt(const std::optional<QPointF> &position)
{
    m_hover = position;
    m_hoveredVertex.reset();
    m_canvas.followPointer();
}

std::optional<VertexRef> CanvasMouse::hoveredVertex() const
{
    if (!m_hover || m_gesture)
        return std::nullopt;
    if (!m_hoveredVertex)
        m_hoveredVertex = m_canvas.vertexAt(*m_hover);
    return *m_hoveredVertex;
}

std::optional<std::size_t> CanvasMouse::hoveredCorner() const
{
    return m_hover && !m_gesture ? imageCornerAt(*m_hover, m_sources, m_view) : std::nullopt;
}

void CanvasMouse::chooseCorner(const std::optional<std::size_t> &corner)
{
    if (corner)
        m_document.selectVertex(std::nullopt);
    if (corner == m_chosenCorner)
        return;
    m_chosenCorner = corner;
    m_canvas.update();
    m_canvas.announce();
}

bool CanvasMouse::isHandleUnderPointer() const
{
    return hoveredVertex() || hoveredCorner()
        || (m_hover && isOffScreenPointAt(*m_hover, m_document, m_view));
}

std::optional<LatticePoint> CanvasMouse::candidate() const
{
    const bool placing = !m_gesture || dynamic_cast<const PlaceVertexGesture *>(m_gesture.get());
    if (m_tool == CanvasTool::Inspect || !m_hover || !placing || !m_view.area().contains(*m_hover)
        || (!m_gesture && isHandleUnderPointer()))
        return std::nullopt;
    return m_view.placeAt(*m_hover);
}

bool CanvasMouse::isMovingVertex() const
{
    return dynamic_cast<const MoveVertexGesture *>(m_gesture.get()) != nullptr;
}

Qt::CursorShape CanvasMouse::cursor() const
{
    if (m_gesture)
        return m_gesture->cursor();
    if (m_hover && m_view.columnRuler().contains(*m_hover))
        return Qt::PointingHandCursor;
    if (m_tool == CanvasTool::Inspect)
        return hoveredCorner() ? Qt::SizeAllCursor : Qt::ArrowCursor;
    if (isHandleUnderPointer())
        return Qt::SizeAllCursor;
    return m_hover && m_view.area().contains(*m_hover) ? Qt::CrossCursor : Qt::ArrowCursor;
}

CanvasMenu::CanvasMenu(SceneDocument *document, const VertexRef &ref, QWidget *parent)
    : QMenu(parent)
{
    setObjectName(u"canvasMenu"_s);
    addAction(tr("Vertex &colour…"), this, [this, ref] { emit colourRequested(ref); });
    addAction(tr("&Coordinates…"), this, [this, ref] { emit coordinatesRequested(ref); });
    addSeparator();
    const bool isPending = ref.primitive == VertexRef::pending;
    if (!isPending && document->kindOf(ref.primitive) == PrimitiveKind::Text)
        addAction(tr("&Text…"), this, [this, document, ref] { askForText(document, ref); });
    if (!isPending)
        addAction(tr("&Hide %1").arg(coreWord(nameOf(document->kindOf(ref.primitive)))), this,
                  [document, ref] { document->hidePrimitive(ref.primitive); });
    addAction(isPending ? tr("&Delete vertex")
                        : tr("&Delete %1").arg(coreWord(nameOf(document->kindOf(ref.primitive)))),
              this, [document, ref] { document->deleteVertex(ref); });
}

void CanvasMenu::askForText(SceneDocument *document, const VertexRef &ref)
{
    const auto index = std::size_t(ref.primitive) - document->scene().triangles.size();
    bool isAccepted = false;
    const QString text = QInputDialog::getText(
        parentWidget(), tr("Text"), tr("The characters that are drawn:"), QLineEdit::Normal,
        QString::fromStdString(document->scene().shapes[index].text), &isAccepted);
    if (isAccepted)
        document->setText(ref.primitive, text);
}

} // namespace pixelplumb
