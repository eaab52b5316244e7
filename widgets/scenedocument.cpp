// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenedocument.h"

#include "core/methods/method.h"
#include "widgets/numberformat.h"
#include "widgets/scenecommands.h"

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

bool isWithinRange(const FrameSpec &frame)
{
    return std::abs(std::int64_t(frame.firstColumn)) <= largestPixel
        && std::abs(std::int64_t(frame.firstRow)) <= largestPixel;
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
    connect(&m_undoStack, &QUndoStack::cleanChanged, this,
            [this](bool clean) { emit modifiedChanged(!clean); });
}

SceneDocument::~SceneDocument()
{
    // The stack says that it is clean when it goes; nobody should hear it from a half-gone
    // document.
    m_undoStack.disconnect(this);
}

Colour SceneDocument::nextColour() const
{
    return m_chosenColour.value_or(defaultColours[m_pending.size()]);
}

std::optional<Vertex> SceneDocument::vertexAt(const VertexRef &ref) const
{
    if (ref.vertex < 0)
        return std::nullopt;
    const auto vertex = std::size_t(ref.vertex);
    if (ref.triangle == VertexRef::pending)
        return vertex < m_pending.size() ? std::optional(m_pending[vertex]) : std::nullopt;
    if (ref.triangle < 0 || std::size_t(ref.triangle) >= m_scene.triangles.size() || vertex >= 3)
        return std::nullopt;
    return m_scene.triangles[std::size_t(ref.triangle)].vertices[vertex];
}

std::vector<VertexRef> SceneDocument::vertices() const
{
    std::vector<VertexRef> refs;
    for (int triangle = 0; triangle < int(m_scene.triangles.size()); ++triangle) {
        for (int vertex = 0; vertex < 3; ++vertex)
            refs.push_back({triangle, vertex});
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

void SceneDocument::reset(const Scene &scene)
{
    m_scene = scene;
    m_pending.clear();
    m_chosenColour.reset();
    m_selected.reset();
    m_undoStack.clear();
    emit selectionChanged();
    emit pendingChanged();
    emit nextColourChanged();
    emit sceneChanged();
}

void SceneDocument::placeVertex(const LatticePoint &position)
{
    if (accepts(position))
        m_undoStack.push(new PlaceVertexCommand(*this, {position, nextColour()}));
}

void SceneDocument::moveVertex(const VertexRef &ref, const LatticePoint &position, int drag)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (vertex && vertex->position != position && accepts(position))
        m_undoStack.push(new MoveVertexCommand(*this, ref, position, drag));
}

void SceneDocument::setVertexColour(const VertexRef &ref, const Colour &colour)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (vertex && vertex->colour != colour)
        m_undoStack.push(new SetVertexColourCommand(*this, ref, colour));
}

void SceneDocument::addTriangle(const Triangle &triangle)
{
    if (std::ranges::all_of(triangle.vertices,
                            [this](const Vertex &vertex) { return accepts(vertex.position); }))
        m_undoStack.push(new InsertTriangleCommand(*this, triangle));
}

void SceneDocument::deleteTriangle(int triangle)
{
    if (triangle >= 0 && std::size_t(triangle) < m_scene.triangles.size())
        m_undoStack.push(new DeleteTriangleCommand(*this, triangle));
}

void SceneDocument::deleteVertex(const VertexRef &ref)
{
    if (ref.triangle != VertexRef::pending) {
        deleteTriangle(ref.triangle);
        return;
    }
    if (!vertexAt(ref))
        return;
    std::vector<Vertex> pending = m_pending;
    pending.erase(pending.begin() + ref.vertex);
    m_undoStack.push(
        new ReplaceVerticesCommand(*this, tr("delete vertex"), m_scene.triangles, pending));
}

void SceneDocument::discardPending()
{
    if (!m_pending.empty())
        m_undoStack.push(
            new ReplaceVerticesCommand(*this, tr("discard vertices"), m_scene.triangles, {}));
}

void SceneDocument::clear()
{
    if (!m_pending.empty() || !m_scene.triangles.empty())
        m_undoStack.push(new ReplaceVerticesCommand(*this, tr("clear"), {}, {}));
}

void SceneDocument::setFrame(const FrameSpec &frame)
{
    if (frame == m_scene.frame)
        return;
    if (frame.width < 1 || frame.height < 1 || frame.width > largestFrameSide
        || frame.height > largestFrameSide
        || std::int64_t(frame.width) * frame.height > largestFrameArea) {
        emit refused(
            tr("A frame of %1 × %2 pixels cannot be made: each side must be 1 to %3 and the "
               "area at most %4.")
                .arg(frame.width)
                .arg(frame.height)
                .arg(largestFrameSide)
                .arg(largestFrameArea));
        return;
    }
    if (!isWithinRange(frame)) {
        emit refused(tr("The frame's first pixel (%1, %2) lies beyond ±2^30 px.")
                         .arg(frame.firstColumn)
                         .arg(frame.firstRow));
        return;
    }
    Scene scene{frame, m_scene.settings, m_scene.method, {}};
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change frame"), scene));
}

void SceneDocument::setSettings(const ScanSettings &settings)
{
    if (settings == m_scene.settings)
        return;
    Scene scene{m_scene.frame, settings, m_scene.method, {}};
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change settings"), scene));
}

void SceneDocument::setMethod(const std::string &method)
{
    if (method == m_scene.method)
        return;
    const QString name = QString::fromStdString(method);
    if (!methodNamed(name)) {
        emit refused(tr("There is no method “%1”.").arg(name));
        return;
    }
    Scene scene{m_scene.frame, m_scene.settings, method, {}};
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change method"), scene));
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

Vertex *SceneDocument::find(const VertexRef &ref)
{
    Q_ASSERT(vertexAt(ref));
    if (ref.triangle == VertexRef::pending)
        return &m_pending[std::size_t(ref.vertex)];
    return &m_scene.triangles[std::size_t(ref.triangle)].vertices[std::size_t(ref.vertex)];
}

bool SceneDocument::accepts(const LatticePoint &position)
{
    if (pixelplumb::isWithinRange(position))
        return true;
    emit refused(tr("A vertex at (%1, %2) is too far away: coordinates must lie within ±2^30 px.")
                     .arg(pixelText(position.x), pixelText(position.y)));
    return false;
}

void SceneDocument::dropStaleSelection()
{
    if (m_selected && !vertexAt(*m_selected)) {
        m_selected.reset();
        emit selectionChanged();
    }
}

} // namespace pixelplumb
