// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenedocument.h"

#include "core/methods/method.h"
#include "widgets/look/numberformat.h"

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

/// As many as keep some 4 million primitives in memory, and three at least.
int stepsOfUndo(const Scene &scene)
{
    constexpr std::size_t mostKept = 4'000'000;
    return int(
        std::max<std::size_t>(3, mostKept / (scene.triangles.size() + scene.shapes.size() + 1)));
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
    if (m_now.chosenColour)
        return *m_now.chosenColour;
    if (!m_now.pending.empty() && hasOneColour(placedKind()))
        return m_now.pending.front().colour;
    return defaultColours[m_now.pending.size() % defaultColours.size()];
}

std::optional<Vertex> SceneDocument::vertexAt(const VertexRef &ref) const
{
    if (ref.vertex < 0)
        return std::nullopt;
    const auto vertex = std::size_t(ref.vertex);
    if (ref.primitive == VertexRef::pending)
        return vertex < m_now.pending.size() ? std::optional(m_now.pending[vertex]) : std::nullopt;
    if (ref.primitive < 0 || ref.primitive >= primitiveCount())
        return std::nullopt;
    const auto primitive = std::size_t(ref.primitive);
    if (primitive < scene().triangles.size())
        return vertex < 3 ? std::optional(scene().triangles[primitive].vertices[vertex])
                          : std::nullopt;
    const std::vector<Vertex> &vertices
        = scene().shapes[primitive - scene().triangles.size()].vertices;
    return vertex < vertices.size() ? std::optional(vertices[vertex]) : std::nullopt;
}

PrimitiveKind SceneDocument::kindOf(int primitive) const
{
    const auto index = std::size_t(primitive);
    return index < scene().triangles.size() ? PrimitiveKind::Triangle
                                            : scene().shapes[index - scene().triangles.size()].kind;
}

const Shape &SceneDocument::shapeAt(int primitive) const
{
    return scene().shapes[std::size_t(primitive) - scene().triangles.size()];
}

std::vector<Vertex> SceneDocument::verticesOf(int primitive) const
{
    const auto index = std::size_t(primitive);
    if (index >= scene().triangles.size())
        return scene().shapes[index - scene().triangles.size()].vertices;
    const std::array<Vertex, 3> &vertices = scene().triangles[index].vertices;
    return {vertices.begin(), vertices.end()};
}

bool SceneDocument::canMovePrimitive(int primitive, int places) const
{
    const auto triangles = int(scene().triangles.size());
    const bool isTriangle = primitive < triangles;
    const int first = isTriangle ? 0 : triangles;
    const int end = isTriangle ? triangles : primitiveCount();
    const int target = primitive + places;
    return primitive >= first && primitive < end && target >= first && target < end;
}

bool SceneDocument::canClosePending() const
{
    return placedKind() == PrimitiveKind::Polygon && m_now.pending.size() >= 3;
}

TriangleAttributes SceneDocument::attributesOf(int triangle) const
{
    const auto found = std::ranges::lower_bound(scene().attributes, std::size_t(triangle), {},
                                                &TriangleAttributes::triangle);
    if (found != scene().attributes.end() && found->triangle == std::size_t(triangle))
        return *found;
    return {.triangle = std::size_t(triangle), .vertices = {}};
}

std::vector<VertexRef> SceneDocument::vertices() const
{
    std::vector<VertexRef> refs;
    const auto triangles = int(scene().triangles.size());
    for (int primitive = 0; primitive < primitiveCount(); ++primitive) {
        const int count = primitive < triangles
            ? 3
            : int(scene().shapes[std::size_t(primitive - triangles)].vertices.size());
        for (int vertex = 0; vertex < count; ++vertex)
            refs.push_back({primitive, vertex});
    }
    for (int vertex = 0; vertex < int(m_now.pending.size()); ++vertex)
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
    if (scene().settings.fillRule != FillRule::OffScreenPoint)
        return std::nullopt;
    const LatticePoint sample = offScreenSample(scene().frame);
    const Lattice offset = sampleOffset(scene().frame);
    return LatticePoint{sample.x + offset, sample.y + offset};
}

void SceneDocument::reset(Scene scene)
{
    const ScanSettings asked = scene.settings;
    if (const Method *method = methodNamed(QString::fromStdString(scene.method)))
        scene.settings = method->adapted(asked);
    m_now = {std::make_shared<const Scene>(std::move(scene)), {}, {}, m_now.number};
    m_selected.reset();
    m_currentFrame = 0;
    m_undoStack.clear();
    m_undoStack.setUndoLimit(stepsOfUndo(*m_now.scene));
    markSaved();
    emit opened();
    emit pendingChanged();
    emit nextColourChanged();
    tellSceneChanged();
    emit selectionChanged(); // last: lists of the scene now show this one, not the old
    tellAdaptation(asked);
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
    m_now.chosenColour = colour;
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

void SceneDocument::edit(const QString &text, const std::function<void(DocumentState &)> &change,
                         const std::optional<Drag> &drag)
{
    DocumentState after = m_now;
    change(after);
    if (*after.scene == scene())
        after.scene = m_now.scene;
    else
        after.number = ++m_lastNumber;
    if (after != m_now)
        m_undoStack.push(new SceneEdit(*this, text, m_now, after, drag));
}

void SceneDocument::editScene(const QString &text, const std::function<void(Scene &)> &change,
                              const std::optional<Drag> &drag)
{
    edit(
        text, [&](DocumentState &after) { change(after.changedScene()); }, drag);
}

void SceneDocument::setScene(const Scene &scene, const QString &text)
{
    editScene(text, [&](Scene &changed) { changed = scene; });
}

void SceneDocument::exchange(const DocumentState &before, const DocumentState &after)
{
    const std::optional<VertexRef> selected = m_selected;
    if (m_selected)
        m_selected = renamed(*m_selected, before, after);
    m_now.scene = after.scene;
    m_now.pending = after.pending;
    m_now.number = after.number;
    // A colour that the person chose since does not belong to the edit.
    if (before.chosenColour != after.chosenColour)
        m_now.chosenColour = after.chosenColour;
    if (m_selected && !vertexAt(*m_selected))
        m_selected.reset();
    if (before.pending != after.pending || before.chosenColour != after.chosenColour) {
        emit pendingChanged();
        emit nextColourChanged();
    }
    if (before.scene != after.scene)
        tellSceneChanged();
    // After the scene, so that listeners find the vertex.
    if (m_selected != selected)
        emit selectionChanged();
    tellModified();
}

} // namespace pixelplumb
