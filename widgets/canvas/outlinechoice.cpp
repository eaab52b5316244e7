// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/outlinechoice.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double handleMargin = 20; ///< logical pixels that a handle may reach into the view

} // namespace

bool SceneBox::touches(const Triangle &triangle) const
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [left, right] = std::minmax({a.position.x, b.position.x, c.position.x});
    const auto [low, high] = std::minmax({a.position.y, b.position.y, c.position.y});
    return right >= least.x && left <= greatest.x && high >= least.y && low <= greatest.y;
}

SceneBox sceneBoxOf(const QRectF &view, const ViewMapping &mapping)
{
    const LatticePoint first = mapping.latticeAt(view.topLeft());
    const LatticePoint last = mapping.latticeAt(view.bottomRight());
    const Lattice offset = sampleOffset(mapping.frame());
    // latticeAt() is exact only to a device pixel.
    const Lattice device
        = (mapping.zoom().framePixels + 1) * unitsPerPixel / mapping.zoom().devicePixels + 1;
    return {
        {std::min(first.x, last.x) + offset - device, std::min(first.y, last.y) + offset - device},
        {std::max(first.x, last.x) + offset + device, std::max(first.y, last.y) + offset + device}};
}

/// A primitive with the number of its visible vertices.
struct OutlineChoice::Counted {
    int primitive = 0;
    std::size_t vertices = 0;
};

void OutlineChoice::take(const Counted &counted)
{
    m_inView.push_back(counted.primitive);
    if (counted.vertices > mostHandles)
        m_bare.push_back(counted.primitive);
    else
        m_verticesInView += counted.vertices;
    m_isCrowded = m_inView.size() > mostInView || m_verticesInView > mostVertices;
}

void OutlineChoice::lookUp(const SceneDocument &document, const ViewMapping &mapping,
                           const QRectF &view)
{
    if (m_isKnown && mapping == m_mapping && view == m_view)
        return;
    m_isKnown = true;
    m_mapping = mapping;
    m_view = view;
    m_inView.clear();
    m_bare.clear();
    m_verticesInView = 0;
    m_isCrowded = false;
    const Scene &scene = document.scene();
    SceneBox box = sceneBoxOf(
        view.adjusted(-handleMargin, -handleMargin, handleMargin, handleMargin), mapping);
    box.least = document.fromCurrentFrame(box.least);
    box.greatest = document.fromCurrentFrame(box.greatest);
    for (std::size_t i = 0; i < scene.triangles.size() && !m_isCrowded; ++i) {
        if (box.touches(scene.triangles[i]))
            take({int(i), 3});
    }
    // A shape may reach far beyond its vertices, so each counts as visible. The ones without
    // handles are determined for all shapes.
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const std::vector<Vertex> &vertices = scene.shapes[i].vertices;
        const auto seen = std::ranges::count_if(
            vertices, [&box](const Vertex &vertex) { return box.contains(vertex.position); });
        if (!m_isCrowded)
            take({int(scene.triangles.size() + i), std::size_t(seen)});
        else if (std::size_t(seen) > mostHandles)
            m_bare.push_back(int(scene.triangles.size() + i));
    }
}

bool OutlineChoice::hasHandles(int primitive) const
{
    return !std::ranges::binary_search(m_bare, primitive);
}

std::vector<int> OutlineChoice::primitives(const Current &current) const
{
    if (!m_isCrowded)
        return m_inView;
    std::vector<int> primitives;
    for (const std::optional<VertexRef> &vertex : {current.selected, current.hovered}) {
        if (vertex && vertex->primitive != VertexRef::pending)
            primitives.push_back(vertex->primitive);
    }
    if (current.stepped)
        primitives.push_back(*current.stepped);
    std::ranges::sort(primitives);
    primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
    return primitives;
}

} // namespace pixelplumb
