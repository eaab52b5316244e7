// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/outlinechoice.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr double handleMargin = 20; ///< logical pixels by which a handle may reach into the view

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
    // latticeAt() is exact to a device pixel.
    const Lattice device
        = (mapping.zoom().framePixels + 1) * unitsPerPixel / mapping.zoom().devicePixels + 1;
    return {
        {std::min(first.x, last.x) + offset - device, std::min(first.y, last.y) + offset - device},
        {std::max(first.x, last.x) + offset + device, std::max(first.y, last.y) + offset + device}};
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
    const Scene &scene = document.scene();
    SceneBox box = sceneBoxOf(
        view.adjusted(-handleMargin, -handleMargin, handleMargin, handleMargin), mapping);
    box.least = document.fromFrameInHand(box.least);
    box.greatest = document.fromFrameInHand(box.greatest);
    for (std::size_t i = 0; i < scene.triangles.size() && m_inView.size() <= mostInView; ++i) {
        if (box.touches(scene.triangles[i]))
            m_inView.push_back(int(i));
    }
    // A shape may reach far beyond its vertices, so each counts as in view.
    for (std::size_t i = 0; i < scene.shapes.size() && m_inView.size() <= mostInView; ++i)
        m_inView.push_back(int(scene.triangles.size() + i));
    m_isCrowded = m_inView.size() > mostInView;
}

std::vector<int> OutlineChoice::primitives(const InHand &inHand) const
{
    if (!m_isCrowded)
        return m_inView;
    std::vector<int> primitives;
    for (const std::optional<VertexRef> &vertex : {inHand.selected, inHand.hovered}) {
        if (vertex && vertex->primitive != VertexRef::pending)
            primitives.push_back(vertex->primitive);
    }
    if (inHand.stepped)
        primitives.push_back(*inHand.stepped);
    std::ranges::sort(primitives);
    primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
    return primitives;
}

} // namespace pixelplumb
