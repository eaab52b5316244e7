// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"
#include "widgets/model/scenedocument.h"

#include <QRectF>

#include <vector>

namespace pixelplumb {

/// The primitives that a canvas outlines and gives handles: all in view while they are few enough
/// to be told apart, else only those that a person deals with. Beyond some hundreds outlines hide
/// the picture, and cost more than it does. The same holds of the handles of one primitive.
class OutlineChoice {
public:
    static constexpr std::size_t mostInView = 300;
    static constexpr std::size_t mostHandles = 300; ///< of one primitive, in view
    static constexpr std::size_t mostVertices = 3 * mostInView; ///< of all, in view

    /// What a person deals with: a crowded view outlines these primitives.
    struct InHand {
        std::optional<VertexRef> selected;
        std::optional<VertexRef> hovered;
        std::optional<int> stepped; ///< the primitive of the step in hand

        bool holds(int primitive) const
        {
            return (selected && selected->primitive == primitive)
                || (hovered && hovered->primitive == primitive) || stepped == primitive;
        }
    };

    /// Looks up which primitives are in view; cheap when neither view nor scene has changed.
    void lookUp(const SceneDocument &document, const ViewMapping &mapping, const QRectF &view);
    /// The scene has changed.
    void forget() { m_isKnown = false; }

    /// Whether more are in view than are outlined for themselves.
    bool isCrowded() const { return m_isCrowded; }
    /// Those to outline, in drawing order.
    std::vector<int> primitives(const InHand &inHand) const;
    /// Whether all vertices of a primitive that is outlined have handles; else those alone that a
    /// person deals with.
    bool hasHandles(int primitive) const;

private:
    struct Counted;
    void take(const Counted &counted);

    bool m_isKnown = false;
    bool m_isCrowded = false;
    ViewMapping m_mapping;
    QRectF m_view;
    std::vector<int> m_inView; ///< ascending; as far as they were counted
    std::size_t m_verticesInView = 0; ///< of these, but for those without handles
    std::vector<int> m_bare; ///< ascending: those with too many vertices for handles
};

/// The scene's coordinates that lie within a rectangle of the view, or a little outside.
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
