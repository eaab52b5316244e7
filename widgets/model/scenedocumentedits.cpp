// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapeediting.h"
#include "core/methods/method.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>
#include <utility>

/// What a person can do to a document; each action is an edit on its undo stack.
namespace pixelplumb {

namespace {

bool isWithinRange(const FrameSpec &frame)
{
    return std::abs(std::int64_t(frame.firstColumn)) <= largestPixel
        && std::abs(std::int64_t(frame.firstRow)) <= largestPixel;
}

/// Makes the pending vertices the last primitive.
void completePending(DocumentState &state, PrimitiveKind kind)
{
    Scene &scene = state.changedScene();
    const std::vector<Vertex> vertices = std::exchange(state.pending, {});
    const Method *drawing = methodNamed(QString::fromStdString(scene.method));
    if (kind == PrimitiveKind::Triangle)
        scene.triangles.push_back({{vertices[0], vertices[1], vertices[2]}});
    else
        scene.shapes.push_back(
            shapeFrom(kind, vertices, drawing ? drawing->fills : std::vector<ShapeFill>()));
}

} // namespace

void SceneDocument::placeVertex(const LatticePoint &position)
{
    if (!accepts(position))
        return;
    edit(tr("place vertex"), [&](DocumentState &after) {
        after.pending.push_back({position, nextColour()});
        if (hasOneColour(placedKind())) { // the colour may have been chosen anew
            for (Vertex &vertex : after.pending)
                vertex.colour = nextColour();
        }
        after.chosenColour.reset();
        const std::optional<std::size_t> needed = placedVertexCount(placedKind());
        if (needed && after.pending.size() >= *needed)
            completePending(after, placedKind());
    });
}

void SceneDocument::moveVertex(const VertexRef &ref, const LatticePoint &position, int drag)
{
    const std::optional<Vertex> vertex = vertexAt(ref);
    if (!vertex || vertex->position == position || !accepts(position))
        return;
    const auto triangles = int(scene().triangles.size());
    edit(
        tr("move vertex"),
        [&](DocumentState &after) {
            if (ref.primitive < triangles)
                after.changedVertex(ref).position = position;
            else
                pixelplumb::moveVertex(
                    after.changedScene().shapes[std::size_t(ref.primitive - triangles)],
                    std::size_t(ref.vertex), position);
        },
        Drag{ref, drag});
}

void SceneDocument::setVertexColour(const VertexRef &ref, const Colour &colour)
{
    if (!vertexAt(ref))
        return;
    if (ref.primitive != VertexRef::pending && hasOneColour(kindOf(ref.primitive)))
        return setPrimitiveColour(ref.primitive, colour);
    edit(tr("change colour"),
         [&](DocumentState &after) { after.changedVertex(ref).colour = colour; });
}

void SceneDocument::setPrimitiveColour(int primitive, const Colour &colour)
{
    if (primitive < 0 || primitive >= primitiveCount())
        return;
    editScene(tr("change colour"), [&](Scene &changed) {
        const auto paint = [&colour](auto &vertices) {
            for (Vertex &vertex : vertices)
                vertex.colour = colour;
        };
        const auto place = std::size_t(primitive);
        const std::size_t triangles = changed.triangles.size();
        place < triangles ? paint(changed.triangles[place].vertices)
                          : paint(changed.shapes[place - triangles].vertices);
    });
}

void SceneDocument::addTriangle(const Triangle &triangle, const TriangleAttributes &attributes)
{
    if (std::ranges::all_of(triangle.vertices,
                            [this](const Vertex &vertex) { return accepts(vertex.position); }))
        editScene(tr("add triangle"), [&](Scene &changed) {
            insert(changed, {changed.triangles.size(), HiddenTriangle{triangle, attributes}});
        });
}

void SceneDocument::setTriangle(int primitive, const Triangle &triangle,
                                const TriangleAttributes &attributes)
{
    if (kindOf(primitive) != PrimitiveKind::Triangle
        || !std::ranges::all_of(triangle.vertices,
                                [this](const Vertex &vertex) { return accepts(vertex.position); }))
        return;
    editScene(tr("change triangle"), [&](Scene &changed) {
        const std::size_t place = take(changed, primitive).place;
        insert(changed, {place, HiddenTriangle{triangle, attributes}});
    });
}

void SceneDocument::closePending()
{
    if (canClosePending())
        edit(tr("close polygon"),
             [](DocumentState &after) { completePending(after, PrimitiveKind::Polygon); });
}

void SceneDocument::setText(int primitive, const QString &text)
{
    if (primitive < 0 || primitive >= primitiveCount() || kindOf(primitive) != PrimitiveKind::Text
        || text.isEmpty())
        return;
    Shape shape = shapeAt(primitive);
    shape.text = text.toStdString();
    changeShape(primitive, shape, tr("change text"));
}

void SceneDocument::setForm(int primitive, const Shape &shape)
{
    changeShape(primitive, shape, tr("change form"));
}

void SceneDocument::changeShape(int primitive, const Shape &shape, const QString &text)
{
    editScene(text, [&](Scene &changed) {
        changed.shapes[std::size_t(primitive) - changed.triangles.size()] = shape;
    });
}

void SceneDocument::deleteVertex(const VertexRef &ref)
{
    if (ref.primitive != VertexRef::pending)
        return deletePrimitive(ref.primitive);
    if (vertexAt(ref))
        edit(tr("delete vertex"), [&](DocumentState &after) {
            after.pending.erase(after.pending.begin() + ref.vertex);
        });
}

/// Pending vertices are undone edit by edit, so that the next undo concerns what came before them;
/// if something else was done since, discarding them is an edit of its own.
void SceneDocument::discardPending()
{
    const auto isOfPending = [this] {
        const int last = m_undoStack.index() - 1;
        const auto *edit
            = last >= 0 ? dynamic_cast<const SceneEdit *>(m_undoStack.command(last)) : nullptr;
        return edit && edit->keepsScene();
    };
    while (!m_now.pending.empty() && isOfPending())
        m_undoStack.undo();
    if (m_now.pending.empty())
        return;
    edit(tr("discard vertices"), [](DocumentState &after) { after.pending.clear(); });
}

void SceneDocument::clear()
{
    edit(tr("clear"), [](DocumentState &after) {
        Scene &changed = after.changedScene();
        changed.triangles.clear();
        changed.attributes.clear();
        changed.shapes.clear();
        changed.hidden.clear();
        changed.solids.clear();
        after.pending.clear();
    });
}

void SceneDocument::setFrame(const FrameSpec &frame)
{
    if (frame == scene().frame)
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
    if (frame.offScreenPoint && !pixelplumb::isWithinRange(*frame.offScreenPoint)) {
        emit refused(tr("The off-screen point lies beyond ±2^30 px."));
        return;
    }
    editScene(tr("change frame"), [&](Scene &changed) { changed.frame = frame; });
}

void SceneDocument::setAppearance(const Appearance &appearance)
{
    editScene(tr("change appearance"), [&](Scene &changed) { changed.appearance = appearance; });
}

void SceneDocument::setLook(const std::optional<Camera> &camera, const Appearance &appearance)
{
    editScene(tr("change camera, light and materials"), [&](Scene &changed) {
        changed.camera = camera;
        changed.appearance = appearance;
    });
}

void SceneDocument::setMotion(const std::optional<Motion> &motion)
{
    editScene(motion ? tr("change motion") : tr("end motion"),
              [&](Scene &changed) { changed.motion = motion; });
}

void SceneDocument::moveOffScreenPoint(const LatticePoint &position, int drag)
{
    if (!pixelplumb::isWithinRange(position)) {
        emit refused(tr("The off-screen point lies beyond ±2^30 px."));
        return;
    }
    editScene(
        tr("move off-screen point"),
        [&](Scene &changed) { changed.frame.offScreenPoint = position; }, Drag{VertexRef(), drag});
}

} // namespace pixelplumb
