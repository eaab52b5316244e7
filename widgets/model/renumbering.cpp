// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/renumbering.h"

#include <algorithm>
#include <cstddef>

namespace pixelplumb {

namespace {

/// The rotation that an edit applies to a run of the same primitives: 1 where the first becomes the
/// last, −1 where the last becomes the first, else 0.
template <class Element>
int turnOf(const std::vector<Element> &before, const std::vector<Element> &after)
{
    if (before.size() != after.size() || before.size() < 2 || before == after)
        return 0;
    const auto isTurned = [](const std::vector<Element> &from, const std::vector<Element> &to) {
        return from.front() == to.back() && std::equal(from.begin() + 1, from.end(), to.begin());
    };
    if (isTurned(before, after))
        return 1;
    return isTurned(after, before) ? -1 : 0;
}

/// The index of a run's primitive after the edit; none where it was removed. An edit that removes
/// or inserts some keeps the others in order.
template <class Element>
std::optional<std::size_t> placeAfter(const std::vector<Element> &before,
                                      const std::vector<Element> &after, std::size_t place)
{
    if (before.size() == after.size()) {
        const auto count = std::ptrdiff_t(before.size());
        return std::size_t((std::ptrdiff_t(place) - turnOf(before, after) + count) % count);
    }
    const bool isLonger = after.size() > before.size();
    const std::vector<Element> &few = isLonger ? before : after;
    const std::vector<Element> &many = isLonger ? after : before;
    std::size_t next = 0;
    for (std::size_t i = 0; i < many.size() && next < few.size(); ++i) {
        if (many[i] != few[next])
            continue;
        if ((isLonger ? next : i) == place)
            return isLonger ? i : next;
        ++next;
    }
    return std::nullopt;
}

} // namespace

std::optional<VertexRef> renamed(const VertexRef &ref, std::size_t triangleCount,
                                 const ScenePiece &before, const ScenePiece &after)
{
    const int moreTriangles
        = int(after.scene.triangles.size()) - int(before.scene.triangles.size());
    const int moreShapes = int(after.scene.shapes.size()) - int(before.scene.shapes.size());
    const int firstShape = int(triangleCount + before.firstShape);
    if (ref.primitive == VertexRef::pending) {
        if (!after.pending.empty() || moreTriangles + moreShapes != 1)
            return ref;
        return VertexRef{moreTriangles == 1 ? int(before.firstTriangle) : firstShape, ref.vertex};
    }
    const bool isTriangle = ref.primitive < int(triangleCount);
    const int first = isTriangle ? int(before.firstTriangle) : firstShape;
    const int count = int(isTriangle ? before.scene.triangles.size() : before.scene.shapes.size());
    const int more = isTriangle ? moreTriangles : moreShapes;
    const bool isInRun = ref.primitive >= first && ref.primitive < first + count;
    if (isInRun && more < 0 && before.pending.empty() && !after.pending.empty())
        return VertexRef{VertexRef::pending, ref.vertex};
    VertexRef result = ref;
    if (isInRun) {
        const auto place = std::size_t(ref.primitive - first);
        const std::optional<std::size_t> found = isTriangle
            ? placeAfter(before.scene.triangles, after.scene.triangles, place)
            : placeAfter(before.scene.shapes, after.scene.shapes, place);
        if (!found)
            return std::nullopt;
        result.primitive = first + int(*found);
    }
    result.primitive += ref.primitive >= first + count ? more : 0;
    result.primitive += isTriangle ? 0 : moreTriangles;
    return result;
}

} // namespace pixelplumb
