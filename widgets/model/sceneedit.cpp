// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/sceneedit.h"

#include "widgets/model/scenedocument.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// Where a primitive is after an edit; none where it was removed. An edit moves one primitive, or
/// inserts or removes some.
template <class Element>
std::optional<std::size_t> placeAfter(const std::vector<Element> &before,
                                      const std::vector<Element> &after, std::size_t place)
{
    const auto [gone, come] = std::ranges::mismatch(before, after);
    const auto first = std::size_t(gone - before.begin());
    if (place < first)
        return place;
    if (before.size() == after.size()) {
        const auto last = std::mismatch(before.rbegin(), before.rend(), after.rbegin()).first;
        const auto end = before.rend() - last; // of those that differ
        const std::size_t back = std::size_t(end) - 1;
        if (place > back)
            return place;
        if (*gone == after[back] && std::equal(gone + 1, before.begin() + end, come))
            return place == first ? back : place - 1;
        if (before[back] == *come && std::equal(gone, before.begin() + end - 1, come + 1))
            return place == back ? first : place + 1;
        return place;
    }
    const bool isLonger = after.size() > before.size();
    const std::vector<Element> &few = isLonger ? before : after;
    const std::vector<Element> &many = isLonger ? after : before;
    for (std::size_t i = first, next = first; i < many.size() && next < few.size(); ++i) {
        if (many[i] != few[next])
            continue;
        if ((isLonger ? next : i) == place)
            return isLonger ? i : next;
        ++next;
    }
    return std::nullopt;
}

} // namespace

Scene &DocumentState::changedScene()
{
    const auto copy = std::make_shared<Scene>(*scene);
    scene = copy;
    return *copy;
}

Vertex &DocumentState::changedVertex(const VertexRef &ref)
{
    const auto index = std::size_t(ref.vertex);
    if (ref.primitive == VertexRef::pending)
        return pending[index];
    Scene &changed = changedScene();
    const auto primitive = std::size_t(ref.primitive);
    return primitive < changed.triangles.size()
        ? changed.triangles[primitive].vertices[index]
        : changed.shapes[primitive - changed.triangles.size()].vertices[index];
}

std::optional<VertexRef> renamed(const VertexRef &ref, const DocumentState &before,
                                 const DocumentState &after)
{
    const Scene &from = *before.scene;
    const Scene &to = *after.scene;
    const bool isMoreTriangles = to.triangles.size() > from.triangles.size();
    const bool isMore = isMoreTriangles || to.shapes.size() > from.shapes.size();
    const auto last
        = int(isMoreTriangles ? to.triangles.size() : to.triangles.size() + to.shapes.size()) - 1;
    if (ref.primitive == VertexRef::pending)
        return isMore && after.pending.empty() ? VertexRef{last, ref.vertex} : ref;
    if (&from == &to)
        return ref;
    const auto primitive = std::size_t(ref.primitive);
    const bool isTriangle = primitive < from.triangles.size();
    const auto place = isTriangle
        ? placeAfter(from.triangles, to.triangles, primitive)
        : placeAfter(from.shapes, to.shapes, primitive - from.triangles.size());
    if (place)
        return VertexRef{int(isTriangle ? *place : to.triangles.size() + *place), ref.vertex};
    if (before.pending.empty() && !after.pending.empty())
        return VertexRef{VertexRef::pending, ref.vertex};
    return std::nullopt;
}

HiddenPrimitive take(Scene &scene, int primitive)
{
    const auto place = std::size_t(primitive);
    const std::size_t triangles = scene.triangles.size();
    if (place >= triangles) {
        const auto shape = scene.shapes.begin() + std::ptrdiff_t(place - triangles);
        HiddenPrimitive taken{place - triangles, std::move(*shape)};
        scene.shapes.erase(shape);
        return taken;
    }
    HiddenTriangle taken{scene.triangles[place], {}};
    scene.triangles.erase(scene.triangles.begin() + primitive);
    auto later
        = std::ranges::lower_bound(scene.attributes, place, {}, &TriangleAttributes::triangle);
    if (later != scene.attributes.end() && later->triangle == place) {
        taken.attributes = *later;
        taken.attributes.triangle = 0;
        later = scene.attributes.erase(later);
    }
    for (; later != scene.attributes.end(); ++later)
        --later->triangle;
    return {place, taken};
}

void insert(Scene &scene, const HiddenPrimitive &primitive)
{
    const auto place = std::ptrdiff_t(primitive.place);
    if (const Shape *shape = std::get_if<Shape>(&primitive.primitive)) {
        scene.shapes.insert(scene.shapes.begin() + place, *shape);
        return;
    }
    const auto &triangle = std::get<HiddenTriangle>(primitive.primitive);
    scene.triangles.insert(scene.triangles.begin() + place, triangle.triangle);
    const auto later = std::ranges::lower_bound(scene.attributes, primitive.place, {},
                                                &TriangleAttributes::triangle);
    for (auto each = later; each != scene.attributes.end(); ++each)
        ++each->triangle;
    TriangleAttributes attributes = triangle.attributes;
    attributes.triangle = 0;
    if (attributes == TriangleAttributes())
        return;
    attributes.triangle = primitive.place;
    scene.attributes.insert(later, attributes);
}

SceneEdit::SceneEdit(SceneDocument &document, const QString &text, DocumentState before,
                     DocumentState after, const std::optional<Drag> &drag)
    : QUndoCommand(text)
    , m_document(&document)
    , m_before(std::move(before))
    , m_after(std::move(after))
    , m_drag(drag)
{
}

void SceneEdit::redo() { m_document->exchange(m_before, m_after); }

void SceneEdit::undo() { m_document->exchange(m_after, m_before); }

bool SceneEdit::mergeWith(const QUndoCommand *other)
{
    const auto &edit = static_cast<const SceneEdit &>(*other);
    if (edit.m_drag != m_drag)
        return false;
    m_after = edit.m_after;
    if (m_after == m_before) { // a drag that returned changed nothing
        setObsolete(true);
        m_document->m_now.number = m_before.number;
        m_document->tellModified();
    }
    return true;
}

} // namespace pixelplumb
