// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/nearclip.h"
#include "core/space/solidvertices.h"

#include <span>

namespace pixelplumb {

/// The scene to project, with its camera and frame.
struct SpaceScene {
    const Camera &camera;
    std::span<const Solid> solids;
    const Appearance &appearance; ///< with the camera's viewer (see viewedBy)
    const FrameSpec &frame;
};

/// One face on its way from space to the frame, in one number type: its vertices, and the corners
/// of its clipped polygon. The lists of vertices match by index, and so do those of corners.
template <class Number>
struct ProjectedFace {
    std::vector<std::size_t> indices; ///< of its vertices in the solid
    std::vector<SpaceVertex<Number>> vertices;
    SpaceVector<Number> normal; ///< the face's own, normalized, or 0
    std::vector<SpaceVector<Number>> views;
    std::vector<ClipVertex<Number>> polygon;
    /// The points that light was computed at: each vertex (Gouraud), the centre (flat), or none.
    std::vector<LitColour<Number>> lit;

    std::vector<ClippedCorner<Number>> clipped;
    std::vector<SpaceVector<Number>> devices; ///< after the perspective division
    std::vector<std::array<Number, 2>> places; ///< in the frame, px
};

/// The sum of the fan's cross products: twice the area vector of a flat polygon.
template <class Number>
SpaceVector<Number> fanArea(const std::vector<SpaceVertex<Number>> &vertices)
{
    const SpaceVector<Number> &first = vertices[0].position;
    SpaceVector<Number> area;
    for (std::size_t i = 2; i < vertices.size(); ++i)
        area = area + cross(vertices[i - 1].position - first, vertices[i].position - first);
    return area;
}

/// Projects the faces of one solid; the next face overwrites the result.
template <class Number>
class FaceProjector {
public:
    FaceProjector(const SpaceScene &scene, const Solid &solid)
        : m_solid(solid)
        , m_appearance(scene.appearance)
        , m_material(materialOf(scene.appearance, solid.material))
        , m_vertices(solid)
        , m_camera(scene.camera, scene.frame)
    {
    }

    const ProjectedFace<Number> &project(std::size_t face)
    {
        takeVertices(face);
        makePolygon();
        clipAtNear(m_face.polygon, m_camera.wAtNear(), m_face.clipped);
        m_face.devices.clear();
        m_face.places.clear();
        for (const ClippedCorner<Number> &corner : m_face.clipped) {
            m_face.devices.push_back(m_camera.divided(corner.vertex.clip));
            m_face.places.push_back(m_camera.toFrame(m_face.devices.back()));
        }
        return m_face;
    }

private:
    using Vector = SpaceVector<Number>;

    void takeVertices(std::size_t face)
    {
        takeFace(m_solid, face, m_face.indices);
        m_face.vertices.clear();
        m_face.views.clear();
        for (const std::size_t index : m_face.indices) {
            m_face.vertices.push_back(m_vertices.vertex(index));
            m_face.views.push_back(m_camera.toView(m_face.vertices.back().position));
        }
        m_face.normal = unit(fanArea(m_face.vertices));
    }

    void makePolygon()
    {
        m_face.polygon.clear();
        for (std::size_t i = 0; i < m_face.vertices.size(); ++i) {
            const SpaceVertex<Number> &vertex = m_face.vertices[i];
            m_face.polygon.push_back({m_camera.toClip(m_face.views[i]),
                                      vertex.position,
                                      vertex.normal.isZero() ? m_face.normal : vertex.normal,
                                      vertex.texture,
                                      {}});
        }
        colourVertices();
    }

    void colourVertices()
    {
        m_face.lit.clear();
        const bool isLit = lightsVertices(m_appearance);
        const bool isFlat = isLit && m_appearance.shading == Shading::Flat;
        const Colour ofFace = isFlat ? lit(faceCentre()) : Colour();
        for (std::size_t i = 0; i < m_face.polygon.size(); ++i) {
            ClipVertex<Number> &vertex = m_face.polygon[i];
            Colour colour = isFlat ? ofFace : ownColour(i);
            if (isLit && m_appearance.shading == Shading::Gouraud)
                colour = lit({colour, {vertex.place, vertex.normal}});
            for (std::size_t channel = 0; channel < 3; ++channel)
                vertex.levels[channel] = Number(colour.channels[channel]);
            vertex.levels[3] = Number(m_face.vertices[i].alpha);
        }
    }

    Colour ownColour(std::size_t i) const
    {
        return tinted(m_face.vertices[i].colour, m_material.diffuse);
    }

    /// The mean position and colour of the vertices, with the face's own normal.
    LitColour<Number> faceCentre() const
    {
        const std::size_t count = m_face.vertices.size();
        LitColour<Number> centre{{}, {{}, m_face.normal}};
        std::array<std::size_t, 3> sums = {};
        for (std::size_t i = 0; i < count; ++i) {
            centre.point.place = centre.point.place + m_face.vertices[i].position;
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums[channel] += ownColour(i).channels[channel];
        }
        centre.point.place = Number(1) / Number(count) * centre.point.place;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            centre.colour.channels[channel]
                = std::uint8_t((2 * sums[channel] + count) / (2 * count));
        }
        return centre;
    }

    Colour lit(const LitColour<Number> &corner)
    {
        m_face.lit.push_back(corner);
        const auto levels = litLevels(m_appearance, m_material, corner.colour, corner.point);
        return {{levelByte(levels[0]), levelByte(levels[1]), levelByte(levels[2])}};
    }

    const Solid &m_solid;
    const Appearance &m_appearance;
    const Material &m_material;
    SolidVertices<Number> m_vertices;
    CameraTransform<Number> m_camera;
    ProjectedFace<Number> m_face;
};

} // namespace pixelplumb
