// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/coordinatetext.h"
#include "widgets/canvas/canvas.h"
#include "widgets/canvas/canvasgesture.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/parts.h"
#include "widgets/model/runnotes.h"

#include <QInputDialog>

namespace pixelplumb {

namespace {

/// Logical pixels of tremor that a click may have.
constexpr double tremble = 3;

/// Moves a vertex to typed coordinates, "26; 53/2"; else says what is wrong with them.
void moveVertexTo(const QString &typed, const VertexRef &ref, SceneDocument &document)
{
    const QStringList parts = typed.split(u';');
    SnapReports moved;
    std::array<Lattice, 2> place = {};
    for (std::size_t i = 0; i < place.size(); ++i) {
        const QString text = parts.value(qsizetype(i)).trimmed();
        const Result<SnappedNumber> number = parseCoordinate(text);
        if (!number || parts.size() != 2) {
            emit document.refused(number ? Canvas::tr("Two coordinates are needed: x; y.")
                                         : number.error().message());
            return;
        }
        place[i] = number->units;
        if (number->isDisplaced())
            moved.add({i == 0 ? u"x"_s : u"y"_s, text, *number});
    }
    document.moveVertex(ref, {place[0], place[1]}, document.newDrag());
    if (const QString note = snapNote(moved); !note.isEmpty())
        emit document.notice(note);
}

} // namespace

MovePointGesture::MovePointGesture(const CanvasView &view, const QPointF &press,
                                   const LatticePoint &start)
    : m_view(view)
    , m_press(press)
    , m_start(start)
{
}

void MovePointGesture::moveTo(const QPointF &position)
{
    m_moving = m_moving || (position - m_press).manhattanLength() > tremble;
    if (!m_moving)
        return;
    const LatticePoint pressed = m_view.mapping().latticeAt(m_press);
    const LatticePoint now = m_view.mapping().latticeAt(position);
    movePoint({m_start.x + now.x - pressed.x, m_start.y + now.y - pressed.y});
}

MoveVertexGesture::MoveVertexGesture(const CanvasView &view, SceneDocument &document,
                                     const VertexRef &ref, const QPointF &press)
    : MovePointGesture(view, press, document.vertexAt(ref)->position)
    , m_document(document)
    , m_ref(ref)
    , m_drag(document.newDrag())
    , m_wasSelected(document.selectedVertex() == ref)
{
    document.selectVertex(ref);
}

void MoveVertexGesture::releaseAt(const QPointF &position)
{
    moveTo(position);
    const bool places = m_wasSelected || !m_document.pendingVertices().empty();
    if (hasMoved() || !places)
        return;
    m_document.selectVertex(std::nullopt);
    m_document.placeVertex(start());
}

void MoveVertexGesture::movePoint(const LatticePoint &place)
{
    const LatticePoint seen = m_document.snapped(m_document.atCurrentFrame(place));
    m_document.moveVertex(m_ref, m_document.fromCurrentFrame(seen), m_drag);
}

void MoveVertexGesture::cancel() { m_document.moveVertex(m_ref, start(), m_drag); }

MoveOffScreenPointGesture::MoveOffScreenPointGesture(const CanvasView &view,
                                                     SceneDocument &document, const QPointF &press)
    : MovePointGesture(view, press, *document.offScreenPoint())
    , m_document(document)
    , m_drag(document.newDrag())
{
}

void MoveOffScreenPointGesture::movePoint(const LatticePoint &place)
{
    m_document.moveOffScreenPoint(m_document.snapped(place), m_drag);
}

void MoveOffScreenPointGesture::cancel()
{
    if (hasMoved())
        m_document.moveOffScreenPoint(start(), m_drag);
}

MoveImageCornerGesture::MoveImageCornerGesture(const CanvasView &view, const CanvasSources &sources,
                                               std::size_t corner, const QPointF &press)
    : MovePointGesture(view, press, imageInView(sources)->corners[corner])
    , m_sources(sources)
    , m_corner(corner)
    , m_before(sources.options->affineImage())
    , m_image(*imageInView(sources))
    , m_drag(sources.document->newDrag())
{
}

void MoveImageCornerGesture::movePoint(const LatticePoint &place)
{
    moveImageCorner(m_sources, m_image, m_corner, place, m_drag);
}

void MoveImageCornerGesture::cancel()
{
    if (hasMoved() && m_sources.options->affineImage() != m_before)
        m_sources.document->undoStack()->push(new ImageEdit(*m_sources.options, m_before, m_drag));
}

void Canvas::editCoordinates(const VertexRef &ref)
{
    SceneDocument *document = m_sources.document;
    const std::optional<Vertex> vertex = document->vertexAt(ref);
    if (!vertex)
        return;
    auto *dialog = named(new QInputDialog(this), "vertexDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Vertex coordinates"));
    dialog->setLabelText(tr("x; y in px: whole numbers, decimals and fractions such as 53/2"));
    dialog->setTextValue(
        u"%1; %2"_s.arg(coordinateText(vertex->position.x), coordinateText(vertex->position.y)));
    connect(dialog, &QInputDialog::textValueSelected, document,
            [document, ref](const QString &text) { moveVertexTo(text, ref, *document); });
    dialog->open();
}

} // namespace pixelplumb
