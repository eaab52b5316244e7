// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvas.h"

#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/canvas/pointerreadout.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/parts.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenetracer.h"
#include "widgets/model/studentpicture.h"

namespace pixelplumb {

namespace {

constexpr int frameTime = 16; ///< ms

} // namespace

Canvas::Canvas(SceneDocument *document, Playhead *playhead, DisplayOptions *options,
               QWidget *parent)
    : QWidget(parent)
    , m_sources{document, playhead, options, nullptr}
    , m_view(document, this)
    , m_mouse(*this, m_view, m_sources)
    , m_keys(*this, m_view, m_mouse, m_sources)
    , m_follower(m_view, m_mouse, playhead)
    , m_imageFollower(document, options)
{
    installCanvasAccessible();
    named(this, "canvas", tr("Canvas"));
    setAccessibleDescription(tr(
        "The frame with its triangles. A click places a vertex or, with the tool Inspect, picks a "
        "pixel. Arrows move the picked pixel, Enter places a vertex there, "
        "brackets choose a vertex, Control with arrows moves it, C changes its colour."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
    m_repaintTimer.setSingleShot(true);
    m_repaintTimer.setTimerType(Qt::PreciseTimer);
    m_repaintTimer.setInterval(frameTime);
    connectSources();
}

Canvas::~Canvas() = default;

void Canvas::connectSources()
{
    const auto repaint = qOverload<>(&QWidget::update);
    const SceneDocument *document = m_sources.document;
    const Playhead *playhead = m_sources.playhead;
    connect(document, &SceneDocument::sceneChanged, this, &Canvas::followScene);
    connect(document, &SceneDocument::currentFrameChanged, this, &Canvas::followScene);
    connect(document, &SceneDocument::pendingChanged, this, &Canvas::updateVertices);
    connect(document, &SceneDocument::nextColourChanged, this, repaint);
    connect(document, &SceneDocument::selectionChanged, this, repaint);
    connect(document, &SceneDocument::selectionChanged, this, &Canvas::announce);
    connect(playhead, &Playhead::tracedChanged, this, repaint);
    connect(playhead, &Playhead::positionChanged, this, repaint);
    connect(playhead, &Playhead::breakpointsChanged, this, repaint);
    connect(playhead, &Playhead::aheadHiddenChanged, this, repaint);
    connect(playhead, &Playhead::pickedPixelChanged, this, repaint);
    connect(playhead, &Playhead::pickedPixelChanged, this, &Canvas::announce);
    connect(m_sources.options, &DisplayOptions::changed, this, repaint);
    connect(&m_view, &CanvasView::changed, this, &Canvas::updateVertices);
    connect(&m_view, &CanvasView::changed, this, &Canvas::followPointer);
    connect(&m_view, &CanvasView::changed, this, &Canvas::viewChanged);
    connect(&m_view, &CanvasView::zoomChanged, this, &Canvas::zoomChanged);
    connect(&m_repaintTimer, &QTimer::timeout, this, repaint);
}

void Canvas::setPreviewer(const ScenePreviewer *previewer)
{
    m_sources.previewer = previewer;
    connect(previewer, &ScenePreviewer::pictureChanged, this, qOverload<>(&QWidget::update));
}

void Canvas::setEffects(const EffectSwitches *effects)
{
    m_sources.effects = effects;
    connect(effects, &EffectSwitches::changesFound, this, qOverload<>(&QWidget::update));
    update();
}

void Canvas::setStudentPicture(const StudentPicture *student)
{
    m_sources.student = student;
    connect(student, &StudentPicture::judged, this, qOverload<>(&QWidget::update));
}

std::optional<VertexRef> Canvas::vertexAt(const QPointF &position) const
{
    return pixelplumb::vertexAt(position, m_sources, m_view, m_outlines);
}

QString Canvas::spokenState() const { return pixelplumb::spokenState(m_sources, hand()); }

void Canvas::announce()
{
    m_keys.endDrag();
    if (m_sources.document->selectedVertex())
        m_mouse.chooseCorner(std::nullopt);
    if (!QAccessible::isActive())
        return;
    QAccessibleValueChangeEvent changed(this, spokenState());
    QAccessible::updateAccessibility(&changed);
}

void Canvas::setZoom(int zoom) { m_view.zoomTo(ViewZoom::fromNumber(zoom), keyboardAnchor()); }

void Canvas::zoomIn() { m_view.zoomTo(mapping().zoom().nextLarger(), keyboardAnchor()); }

void Canvas::zoomOut() { m_view.zoomTo(mapping().zoom().nextSmaller(), keyboardAnchor()); }

void Canvas::fitToView() { m_view.fit(); }

void Canvas::setTool(CanvasTool tool)
{
    if (tool == m_mouse.tool())
        return;
    m_mouse.setTool(tool);
    followPointer();
    emit toolChanged(tool);
}

QString Canvas::readout()
{
    const std::optional<QPointF> &pointer = m_mouse.hover();
    const std::optional<QPoint> pixel = pointer ? pixelAt(*pointer) : std::nullopt;
    const bool isDrawing = m_mouse.isPressed() && tool() == CanvasTool::Draw;
    return pixel && !isDrawing ? m_readout.text(*pixel, m_sources, hand()) : QString();
}

void Canvas::updateVertices()
{
    m_mouse.forgetHovered();
    update();
}

/// Repaints together with the picture of the change if that comes within a frame, so that a drag
/// does not paint everything twice; else without it.
void Canvas::updateSoon()
{
    if (!m_sources.previewer)
        update();
    else if (!m_repaintTimer.isActive())
        m_repaintTimer.start();
}

void Canvas::followScene()
{
    m_outlines.forget();
    m_mouse.forgetHovered();
    updateSoon();
    m_view.followFrame();
}

void Canvas::followPointer()
{
    const std::optional<QPointF> &position = m_mouse.hover();
    const bool inView = position && view().contains(*position);
    std::optional<QPoint> pixel;
    if (inView)
        pixel = QPoint(mapping().columnAt(*position), mapping().rowAt(*position));
    emit hovered(pixel);
    setCursor(m_mouse.cursor());
    if (!m_repaintTimer.isActive())
        update();
}

QPointF Canvas::keyboardAnchor() const
{
    const std::optional<QPoint> picked = m_sources.playhead->pickedPixel();
    const QPointF position = picked ? positionOf(*picked) : view().center();
    return view().contains(position) ? position : view().center();
}

CanvasHand Canvas::hand() const
{
    const std::optional<LatticePoint> pointed = m_mouse.candidate();
    return {m_mouse.hoveredVertex(), m_mouse.hoveredCorner(),
            m_mouse.chosenCorner(),  pointed ? pointed : m_keys.candidate(),
            m_mouse.isPressed(),     m_mouse.isMovingVertex() || m_keys.isMovingVertex(),
            m_keys.isPeeking(),      tool() == CanvasTool::Draw,
            m_mouse.hover(),         {}};
}

bool Canvas::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride)
        m_keys.endPeek(); // Shift belongs to a shortcut
    return QWidget::event(event);
}

void Canvas::paintEvent(QPaintEvent *)
{
    m_view.followDevice();
    m_repaintTimer.stop();
    m_outlines.lookUp(*m_sources.document, mapping(), view());
    QPainter painter(this);
    CanvasHand hand = this->hand();
    hand.readout = readout();
    CanvasScene scene = canvasScene(m_sources, m_view, m_outlines, hand);
    m_layers.addTo(scene, m_sources, m_view);
    m_painter.paint(painter, scene, m_view, palette());
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(view().adjusted(0, 0, -1, -1));
    }
}

void Canvas::resizeEvent(QResizeEvent *) { m_view.followSize(); }

void Canvas::mousePressEvent(QMouseEvent *event)
{
    m_keys.endPeek();
    m_mouse.press(event);
}

void Canvas::mouseMoveEvent(QMouseEvent *event) { m_mouse.move(event->position()); }

void Canvas::mouseReleaseEvent(QMouseEvent *event) { m_mouse.release(event); }

void Canvas::mouseDoubleClickEvent(QMouseEvent *event) { m_mouse.doubleClick(event); }

void Canvas::contextMenuEvent(QContextMenuEvent *event)
{
    // A right press was handled already; only the menu key arrives here.
    if (event->reason() != QContextMenuEvent::Keyboard)
        return;
    const SceneDocument &document = *m_sources.document;
    if (const std::optional<VertexRef> ref = document.selectedVertex())
        m_mouse.openVertexMenu(
            *ref, positionOf(document.atCurrentFrame(document.vertexAt(*ref)->position)));
}

void Canvas::wheelEvent(QWheelEvent *event) { m_mouse.turn(event); }

void Canvas::leaveEvent(QEvent *) { m_mouse.hoverAt(std::nullopt); }

void Canvas::keyPressEvent(QKeyEvent *event)
{
    if (!m_keys.press(event))
        QWidget::keyPressEvent(event);
}

void Canvas::keyReleaseEvent(QKeyEvent *event)
{
    if (!m_keys.release(event))
        QWidget::keyReleaseEvent(event);
}

void Canvas::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void Canvas::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    m_keys.endPeek();
    m_keys.endDrag();
    update();
}

} // namespace pixelplumb
