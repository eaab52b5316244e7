// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"
#include "widgets/model/scenedocument.h"

#include <QRectF>

#include <vector>

namespace pixelplumb {

/// The primitives that a canvas outlines and gives handles: all visible ones while they are few
/// enough to tell apart, else only those in use. Beyond some hundreds, outlines hide the picture
/// and cost more than it does. The same limit holds for the handles of one primitive.
class OutlineChoice {
public:
    static constexpr std::size_t mostInView = 300;
    static constexpr std::size_t mostHandles = 300; ///< of one primitive, visible
    static constexpr std::size_t mostVertices = 3 * mostInView; ///< of all, visible

    /// What a person is working with: a crowded view outlines only these primitives.
    struct Current {
        std::optional<VertexRef> selected;
        std::optional<VertexRef> hovered;
        std::optional<int> stepped; ///< the current step's primitive

        bool holds(int primitive) const
        {
            return (selected && selected->primitive == primitive)
                || (hovered && hovered->primitive == primitive) || stepped == primitive;
        }
    };

    /// Looks up which primitives are visible; cheap when neither view nor scene has changed.
    void lookUp(const SceneDocument &document, const ViewMapping &mapping, const QRectF &view);
    /// To be called when the scene has changed.
    void forget() { m_isKnown = false; }

    /// Whether more primitives are visible than are all outlined.
    bool isCrowded() const { return m_isCrowded; }
    /// The primitives to outline, in drawing order.
    std::vector<int> primitives(const Current &current) const;
    /// Whether all vertices of an outlined primitive have handles, or only those in use.
    bool hasHandles(int primitive) const;

private:
    struct Counted;
    void take(const Counted &counted);

    bool m_isKnown = false;
    bool m_isCrowded = false;
    ViewMapping m_mapping;
    QRectF m_view;
    std::vector<int> m_inView; ///< ascending; incomplete where counting stopped early
    std::size_t m_verticesInView = 0; ///< without those of m_bare
    std::vector<int> m_bare; ///< ascending: primitives with too many vertices for handles
};

/// The scene's coordinates within a rectangle of the view, or a little outside.
struct SceneBox {
    LatticePoint least;
    LatticePoint greatest;

    bool contains(const LatticePoint &point) const
    {
        return point.x >= least.x && point.x <= greatest.x && point.y >= least.y
            && point.y <= greatest.y;
    }
    /// Whether the bounding boxes share a point.
    bool touches(const Triangle &triangle) const;
};
SceneBox sceneBoxOf(const QRectF &view, const ViewMapping &mapping);

} // namespace pixelplumb
