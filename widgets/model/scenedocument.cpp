// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenedocument.h"

#include "core/methods/method.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/renumbering.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Red, green, blue: the corners of the textbook's smoothly shaded triangle.
constexpr std::array<Colour, 3> defaultColours
    = {Colour{{255, 0, 0}}, Colour{{0, 255, 0}}, Colour{{0, 0, 255}}};

QString pixelText(Lattice coordinate)
{
    return displayText(Quantity::rational(coordinate, unitsPerPixel));
}

Lattice nearestMultiple(Lattice coordinate, Lattice step)
{
    return floorDivide(coordinate + step / 2, step) * step;
}

} // namespace

Lattice stepOf(Snap snap)
{
    switch (snap) {
    case Snap::Pixel:
        return unitsPerPixel;
    case Snap::Sixteenth:
        return unitsPerPixel / 16;
    case Snap::Finest:
        break;
    }
    return 1;
}

SceneDocument::SceneDocument(QObject *parent)
    : QObject(parent)
{
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, [this](bool clean) {
        if (clean)
            markSaved();
    });
    markSaved();
}

SceneDocument::~SceneDocument()
{
    // The undo stack reports that it is clean when destroyed; nobody should hear that from a
    // half-destroyed document.
    m_undoStack.disconnect(this);
}

Colour SceneDocument::nextColour() const
{
    if (m_chosenColour)
        return *m_chosenColour;
    if (!m_pending.empty() && hasOneColour(placedKind()))
        return m_pending.front().colour;
    return defaultColours[m_pending.size() % defaultColours.size()];
}

std::optional<Vertex> SceneDocument::vertexAt(const VertexRef &ref) const
{
    if (ref.vertex < 0)
        return std::nullopt;
    const auto vertex = std::size_t(ref.vertex);
    if (ref.primitive == VertexRef::pending)
        return vertex < m_pending.size() ? std::optional(m_pending[vertex]) : std::nullopt;
    if (ref.primitive < 0 || ref.primitive >= primitiveCount())
        return std::nullopt;
    const auto primitive = std::size_t(ref.primitive);
    if (primitive < m_scene.triangles.size())
        return vertex < 3 ? std::optional(m_scene.triangles[primitive].vertices[vertex])
                          : std::nullopt;
    const std::vector<Vertex> &vertices
        = m_scene.shapes[primitive - m_scene.triangles.size()].vertices;
    return vertex < vertices.size() ? std::optional(vertices[vertex]) : std::nullopt;
}

PrimitiveKind SceneDocument::kindOf(int primitive) const
{
    const auto index = std::size_t(primitive);
    return index < m_scene.triangles.size() ? PrimitiveKind::Triangle
                                            : m_scene.shapes[index - m_scene.triangles.size()].kind;
}

const Shape &SceneDocument::shapeAt(int primitive) const
{
    return m_scene.shapes[std::size_t(primitive) - m_scene.triangles.size()];
}

std::vector<Vertex> SceneDocument::verticesOf(int primitive) const
{
    const auto index = std::size_t(primitive);
    if (index >= m_scene.triangles.size())
        return m_scene.shapes[index - m_scene.triangles.size()].vertices;
    const std::array<Vertex, 3> &vertices = m_scene.triangles[index].vertices;
    return {vertices.begin(), vertices.end()};
}

bool SceneDocument::canMovePrimitive(int primitive, int places) const
{
    const auto triangles = int(m_scene.triangles.size());
    const bool isTriangle = primitive < triangles;
    const int first = isTriangle ? 0 : triangles;
    const int end = isTriangle ? triangles : primitiveCount();
    const int target = primitive + places;
    return primitive >= first && primitive < end && target >= first && target < end;
}

bool SceneDocument::canClosePending() const
{
    return placedKind() == PrimitiveKind::Polygon && m_pending.size() >= 3;
}

TriangleAttributes SceneDocument::attributesOf(int triangle) const
{
    const auto found = std::ranges::lower_bound(m_scene.attributes, std::size_t(triangle), {},
                                                &TriangleAttributes::triangle);
    if (found != m_scene.attributes.end() && found->triangle == std::size_t(triangle))
        return *found;
    return {.triangle = std::size_t(triangle), .vertices = {}};
}

std::vector<VertexRef> SceneDocument::vertices() const
{
    std::vector<VertexRef> refs;
    const auto triangles = int(m_scene.triangles.size());
    for (int primitive = 0; primitive < primitiveCount(); ++primitive) {
        const int count = primitive < triangles
            ? 3
            : int(m_scene.shapes[std::size_t(primitive - triangles)].vertices.size());
        for (int vertex = 0; vertex < count; ++vertex)
            refs.push_back({primitive, vertex});
    }
    for (int vertex = 0; vertex < int(m_pending.size()); ++vertex)
        refs.push_back({VertexRef::pending, vertex});
    return refs;
}

LatticePoint SceneDocument::snapped(const LatticePoint &point) const
{
    const Lattice step = stepOf(m_snap);
    return {nearestMultiple(point.x, step), nearestMultiple(point.y, step)};
}

std::optional<LatticePoint> SceneDocument::offScreenPoint() const
{
    if (m_scene.settings.fillRule != FillRule::OffScreenPoint)
        return std::nullopt;
    const LatticePoint sample = offScreenSample(m_scene.frame);
    const Lattice offset = sampleOffset(m_scene.frame);
    return LatticePoint{sample.x + offset, sample.y + offset};
}

void SceneDocument::reset(Scene scene)
{
    const ScanSettings asked = scene.settings;
    if (const Method *method = methodNamed(QString::fromStdString(scene.method)))
        scene.settings = method->adapted(asked);
    m_scene = std::move(scene);
    m_snapshot.reset();
    m_pending.clear();
    m_chosenColour.reset();
    m_selected.reset();
    m_currentFrame = 0;
    m_undoStack.clear();
    markSaved();
    emit opened();
    emit pendingChanged();
    emit nextColourChanged();
    tellSceneChanged();
    emit selectionChanged(); // last: lists of the scene now show this one, not the old
    tellAdaptation(asked);
}

void SceneDocument::setScene(const Scene &scene, const QString &text)
{
    const ScenePiece before = wholePiece();
    const ScenePiece after = withPending(pixelplumb::wholePiece(scene));
    if (after != before)
        m_undoStack.push(new SceneEdit(*this, text, before, after));
}

void SceneDocument::setSnap(Snap snap)
{
    if (snap == m_snap)
        return;
    m_snap = snap;
    emit snapChanged();
}

void SceneDocument::setNextColour(const Colour &colour)
{
    if (colour == nextColour())
        return;
    m_chosenColour = colour;
    emit nextColourChanged();
}

void SceneDocument::selectVertex(const std::optional<VertexRef> &ref)
{
    if (ref == m_selected || (ref && !vertexAt(*ref)))
        return;
    m_selected = ref;
    emit selectionChanged();
}

bool SceneDocument::accepts(const LatticePoint &position)
{
    if (pixelplumb::isWithinRange(position))
        return true;
    emit refused(tr("A vertex at (%1, %2) is too far away: coordinates must lie within ±2^30 px.")
                     .arg(pixelText(position.x), pixelText(position.y)));
    return false;
}

ScenePiece SceneDocument::withPending(ScenePiece piece) const
{
    piece.pending = m_pending;
    piece.chosenColour = m_chosenColour;
    return piece;
}

ScenePiece SceneDocument::pieceAtEnd() const
{
    return withPending(pixelplumb::pieceAtEnd(m_scene));
}

ScenePiece SceneDocument::pieceWith(int primitive) const
{
    if (primitive == VertexRef::pending)
        return pieceAtEnd();
    return withPending(pixelplumb::pieceWith(m_scene, std::size_t(primitive)));
}

ScenePiece SceneDocument::wholePiece() const
{
    return withPending(pixelplumb::wholePiece(m_scene));
}

void SceneDocument::exchange(const ScenePiece &before, const ScenePiece &after, int state)
{
    m_state = state;
    const std::optional<VertexRef> selected = m_selected;
    if (m_selected)
        m_selected = renamed(*m_selected, m_scene.triangles.size(), before, after);
    replace(m_scene, before, after);
    m_pending = after.pending;
    // A colour that the person chose since does not belong to the edit.
    if (before.chosenColour != after.chosenColour)
        m_chosenColour = after.chosenColour;
    if (m_selected && !vertexAt(*m_selected))
        m_selected.reset();
    if (before.pending != after.pending || before.chosenColour != after.chosenColour) {
        emit pendingChanged();
        emit nextColourChanged();
    }
    if (!before.hasSceneOf(after))
        tellSceneChanged();
    // After the scene, so that listeners find the vertex.
    if (m_selected != selected)
        emit selectionChanged();
    tellModified();
}

} // namespace pixelplumb
