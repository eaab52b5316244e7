// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"

#include "widgets/canvasaccessible.h"
#include "widgets/displayoptions.h"
#include "widgets/numberformat.h"
#include "widgets/playhead.h"
#include "widgets/ruler.h"
#include "widgets/scenepreviewer.h"
#include "widgets/vertexdialog.h"

#include <QAccessible>
#include <QEvent>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double fitMargin = 12; ///< for handles of vertices on the frame's border

constexpr int frameTime = 16; ///< ms
constexpr int peekDelay = 180; ///< ms: Shift with another key is not a wish to peek

QPointF fractionOf(const QWidget &widget)
{
    const QPointF corner
        = QPointF(widget.mapTo(widget.window(), QPoint(0, 0))) * widget.devicePixelRatioF();
    return {corner.x() - std::floor(corner.x()), corner.y() - std::floor(corner.y())};
}

} // namespace

Canvas::Canvas(SceneDocument *document, Playhead *playhead, DisplayOptions *options,
               QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_playhead(playhead)
    , m_options(options)
{
    installCanvasAccessible();
    setObjectName(QStringLiteral("canvas"));
    setAccessibleName(tr("Canvas"));
    setAccessibleDescription(tr(
        "The frame with its triangles. Arrows move the picked pixel, Enter places a vertex there, "
        "brackets choose a vertex, Control with arrows moves it, C changes its colour."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
    m_peekTimer.setSingleShot(true);
    m_peekTimer.setInterval(peekDelay);
    m_repaintTimer.setSingleShot(true);
    m_repaintTimer.setTimerType(Qt::PreciseTimer);
    m_repaintTimer.setInterval(frameTime);
    connect(&m_repaintTimer, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    connectSources();
    m_mapping = fittedMapping();
}

Canvas::~Canvas() = default;

void Canvas::connectSources()
{
    const auto repaint = qOverload<>(&QWidget::update);
    connect(m_document, &SceneDocument::sceneChanged, this, &Canvas::followScene);
    connect(m_document, &SceneDocument::pendingChanged, this, &Canvas::followVertices);
    connect(m_document, &SceneDocument::nextColourChanged, this, repaint);
    connect(m_document, &SceneDocument::selectionChanged, this, repaint);
    connect(m_document, &SceneDocument::selectionChanged, this, &Canvas::announce);
    connect(m_playhead, &Playhead::tracedChanged, this, repaint);
    connect(m_playhead, &Playhead::positionChanged, this, repaint);
    connect(m_playhead, &Playhead::breakpointsChanged, this, repaint);
    connect(m_playhead, &Playhead::pickedPixelChanged, this, repaint);
    connect(m_playhead, &Playhead::pickedPixelChanged, this, &Canvas::announce);
    connect(m_options, &DisplayOptions::changed, this, repaint);
    connect(&m_peekTimer, &QTimer::timeout, this, [this] { setPeek(Peek::On); });
}

QString Canvas::zoomText() const
{
    const ViewZoom &zoom = m_mapping.zoom();
    return zoom.framePixels > 1 ? tr("1:%1").arg(zoom.framePixels)
                                : tr("%1×").arg(zoom.devicePixels);
}

std::optional<QPoint> Canvas::pixelAt(const QPointF &position) const
{
    return view().contains(position) ? m_mapping.pixelAt(position) : std::nullopt;
}

QPointF Canvas::positionOf(const LatticePoint &scenePoint) const
{
    return m_mapping.positionOf(onSamples(scenePoint));
}

LatticePoint Canvas::placeAt(const QPointF &position) const
{
    const FrameSpec &frame = m_mapping.frame();
    // The pixel under the pointer, even where the pointer is on the very edge of its cell.
    if (m_document->snap() == Snap::Pixel && frame.pixelCentre == PixelCentre::Integer)
        return latticePixel(m_mapping.columnAt(position), m_mapping.rowAt(position));
    const LatticePoint sample = m_mapping.latticeAt(position);
    const Lattice offset = sampleOffset(frame);
    return m_document->snapped({sample.x + offset, sample.y + offset});
}

QRectF Canvas::view() const
{
    const QFontMetricsF metrics(font());
    const FrameSpec &frame = m_document->scene().frame;
    const double left = rowRulerWidth(metrics, frame);
    const double ruler = columnRulerHeight(metrics);
    const bool below = frame.origin == FrameOrigin::BottomLeft;
    return {left, below ? 0 : ruler, std::max(1.0, width() - left),
            std::max(1.0, height() - ruler)};
}

QRectF Canvas::columnRuler() const
{
    const QRectF frameView = view();
    const double thickness = height() - frameView.height();
    return {frameView.left(), frameView.top() > 0 ? 0 : frameView.bottom(), frameView.width(),
            thickness};
}

QRectF Canvas::rowRuler() const
{
    const QRectF frameView = view();
    return {0, frameView.top(), frameView.left(), frameView.height()};
}

bool Canvas::isTruthVisible() const { return m_options->isTruthShown() || m_peek == Peek::On; }

QString Canvas::spokenState() const
{
    if (const std::optional<VertexRef> ref = m_document->selectedVertex()) {
        const Vertex vertex = *m_document->vertexAt(*ref);
        const QString x = displayText(Quantity::rational(vertex.position.x, unitsPerPixel));
        const QString y = displayText(Quantity::rational(vertex.position.y, unitsPerPixel));
        if (ref->primitive == VertexRef::pending)
            return tr("waiting vertex %1 at (%2, %3)").arg(QString::number(ref->vertex), x, y);
        return tr("vertex %1 of %2 %3 at (%4, %5)")
            .arg(QString::number(ref->vertex), nameOf(m_document->kindOf(ref->primitive)),
                 QString::number(ref->primitive), x, y);
    }
    if (const std::optional<QPoint> pixel = m_playhead->pickedPixel())
        return tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y());
    return tr("no pixel is picked");
}

void Canvas::announce()
{
    m_keyDrag.reset();
    if (!QAccessible::isActive())
        return;
    QAccessibleValueChangeEvent changed(this, spokenState());
    QAccessible::updateAccessibility(&changed);
}

void Canvas::moveViewBy(const QPoint &devicePixels)
{
    m_fit = ViewFit::Free;
    setMapping(m_mapping.movedBy(devicePixels).keptInside(view()));
}

QSize Canvas::sizeHint() const { return {720, 560}; }

QSize Canvas::minimumSizeHint() const { return {240, 200}; }

void Canvas::setZoom(int zoom) { zoomTo(ViewZoom::fromNumber(zoom), keyboardAnchor()); }

void Canvas::zoomIn() { zoomTo(m_mapping.zoom().nextLarger(), keyboardAnchor()); }

void Canvas::zoomOut() { zoomTo(m_mapping.zoom().nextSmaller(), keyboardAnchor()); }

void Canvas::fitToView()
{
    m_fit = ViewFit::Following;
    setMapping(fittedMapping());
}

void Canvas::editCoordinates(const VertexRef &ref)
{
    if (!m_document->vertexAt(ref))
        return;
    auto *dialog = new VertexDialog(m_document, ref, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void Canvas::setPreviewer(const ScenePreviewer *previewer)
{
    m_previewer = previewer;
    connect(previewer, &ScenePreviewer::pictureChanged, this, qOverload<>(&QWidget::update));
    update();
}

void Canvas::followVertices()
{
    m_hoveredVertex.reset();
    update();
}

/// With the picture of the change when that comes within a frame, so that a drag does not paint
/// everything twice; else without it.
void Canvas::updateSoon()
{
    if (!m_previewer)
        update();
    else if (!m_repaintTimer.isActive())
        m_repaintTimer.start();
}

void Canvas::followScene()
{
    m_outlines.forget();
    m_hoveredVertex.reset();
    updateSoon();
    const FrameSpec &frame = m_document->scene().frame;
    if (frame != m_mapping.frame()) {
        const ViewMapping kept(frame, m_mapping.zoom(), m_mapping.origin(),
                               m_mapping.devicePixelRatio(), m_mapping.fraction());
        setMapping(m_fit == ViewFit::Following ? fittedMapping() : kept.keptInside(view()));
    }
}

void Canvas::followDevice()
{
    const double ratio = devicePixelRatioF();
    const QPointF fraction = fractionOf(*this);
    if (ratio == m_mapping.devicePixelRatio() && fraction == m_mapping.fraction())
        return;
    if (m_fit == ViewFit::Following) {
        setMapping(fittedMapping());
        return;
    }
    const QPointF corner = m_mapping.positionOfDevice(m_mapping.origin());
    const ViewMapping moved(m_mapping.frame(), m_mapping.zoom(), {}, ratio, fraction);
    setMapping(moved.movedBy(moved.deviceAt(corner)).keptInside(view()));
}

void Canvas::setMapping(const ViewMapping &mapping)
{
    const bool zoomed = mapping.zoom() != m_mapping.zoom();
    m_mapping = mapping;
    m_hoveredVertex.reset();
    update();
    if (zoomed)
        emit zoomChanged(zoom());
}

void Canvas::zoomTo(const ViewZoom &zoom, const QPointF &anchor)
{
    // No smaller than needed to see the whole frame, and never a frame that fits below 1:1.
    const int least = std::min(1, fittedMapping().zoom().number());
    const ViewZoom allowed = ViewZoom::fromNumber(std::max(zoom.number(), least));
    m_fit = ViewFit::Free;
    setMapping(m_mapping.zoomedAt(anchor, allowed).keptInside(view()));
}

ViewMapping Canvas::fittedMapping() const
{
    const QRectF room = view().adjusted(fitMargin, fitMargin, -fitMargin, -fitMargin);
    return ViewMapping::fitted(m_document->scene().frame, room, devicePixelRatioF(),
                               fractionOf(*this));
}

QPointF Canvas::keyboardAnchor() const
{
    const std::optional<QPoint> picked = m_playhead->pickedPixel();
    const QPointF position = picked ? positionOf(*picked) : view().center();
    return view().contains(position) ? position : view().center();
}

const TracedScene *Canvas::tracedOfFrame() const
{
    const TracedScene *traced = m_playhead->traced();
    return traced && traced->scene.frame == m_document->scene().frame ? traced : nullptr;
}

} // namespace pixelplumb
