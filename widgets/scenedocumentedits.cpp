// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "widgets/scenecommands.h"
#include "widgets/scenedocument.h"

#include <algorithm>

/// What a person may do to a document: each becomes a command on its undo stack.
namespace pixelplumb {

namespace {

QString nameText(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

bool isWithinRange(const FrameSpec &frame)
{
    return std::abs(std::int64_t(frame.firstColumn)) <= largestPixel
        && std::abs(std::int64_t(frame.firstRow)) <= largestPixel;
}

} // namespace

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

void SceneDocument::closePending()
{
    if (canClosePending())
        m_undoStack.push(new ClosePolygonCommand(*this));
}

void SceneDocument::setText(int primitive, const QString &text)
{
    const Shape *shape = findShape(primitive);
    const std::string utf8 = text.toStdString();
    if (shape && shape->kind == PrimitiveKind::Text && !text.isEmpty() && shape->text != utf8)
        m_undoStack.push(new SetTextCommand(*this, primitive, utf8));
}

void SceneDocument::deletePrimitive(int primitive)
{
    if (primitive >= 0 && primitive < primitiveCount())
        m_undoStack.push(new DeletePrimitiveCommand(*this, primitive));
}

void SceneDocument::deleteVertex(const VertexRef &ref)
{
    if (ref.primitive != VertexRef::pending) {
        deletePrimitive(ref.primitive);
        return;
    }
    if (!vertexAt(ref))
        return;
    std::vector<Vertex> pending = m_pending;
    pending.erase(pending.begin() + ref.vertex);
    m_undoStack.push(new ReplaceVerticesCommand(*this, tr("delete vertex"), primitives(), pending));
}

void SceneDocument::discardPending()
{
    if (!m_pending.empty())
        m_undoStack.push(
            new ReplaceVerticesCommand(*this, tr("discard vertices"), primitives(), {}));
}

void SceneDocument::clear()
{
    if (!m_pending.empty() || primitiveCount() > 0)
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
    Scene scene{frame, m_scene.settings, m_scene.method, {}, {}, {}};
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change frame"), scene));
}

void SceneDocument::setSettings(const ScanSettings &settings)
{
    if (settings == m_scene.settings)
        return;
    Scene scene{m_scene.frame, settings, m_scene.method, {}, {}, {}};
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change settings"), scene));
}

void SceneDocument::setMethod(const std::string &method)
{
    if (method == m_scene.method)
        return;
    const QString name = QString::fromStdString(method);
    const Method *chosen = methodNamed(name);
    if (!chosen) {
        emit refused(tr("There is no method “%1”.").arg(name));
        return;
    }
    discardPending(); // they waited for a primitive of another kind, perhaps
    const ScanSettings settings = chosen->adapted(m_scene.settings);
    if (settings != m_scene.settings)
        emit notice(tr("%1. Changed to %2, %3.")
                        .arg(chosen->refusal(m_scene.settings),
                             nameText(nameOf(settings.arithmetic)),
                             nameText(nameOf(settings.fillRule))));
    Scene scene;
    scene.frame = m_scene.frame;
    scene.settings = settings;
    scene.method = method;
    m_undoStack.push(new SetUpSceneCommand(*this, tr("change method"), scene));
}

} // namespace pixelplumb
