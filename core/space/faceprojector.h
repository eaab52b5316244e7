// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cameratransform.h"
#include "core/space/solidvertices.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pixelplumb {

/// A face's vertex with everything that is interpolated.
template <class Number>
struct ClipVertex {
    ClipPoint<Number> clip;
    SpaceVector<Number> place; ///< in the scene's space
    SpaceVector<Number> normal;
    std::array<Number, 2> texture = {};
    std::array<Number, 4> levels = {}; ///< red, green, blue, alpha: 0 … 255

    /// At or beyond the near plane.
    bool isInside() const { return clip.z >= 0; }
    bool isOnPlane() const { return clip.z == 0; }
};

/// A corner of the clipped polygon: a kept vertex, or the cut of an edge.
template <class Number>
struct ClippedCorner {
    ClipVertex<Number> vertex;
    std::size_t inside = 0; ///< the vertex, or the kept end of the cut edge
    std::size_t outside = 0; ///< the same vertex, or the other end of the edge
    Number t = Number(0); ///< from the inside end to the outside one

    bool isCut() const { return inside != outside; }
};

/// The edge's intersection with the near plane. It is computed from the inside end whichever way
/// the edge runs, so that both faces at an edge get the same point; z and w are those of the plane.
template <class Number>
ClippedCorner<Number> cutEdge(const std::vector<ClipVertex<Number>> &polygon, std::size_t inside,
                              std::size_t outside, const Number &wAtNear)
{
    const ClipVertex<Number> &a = polygon[inside];
    const ClipVertex<Number> &b = polygon[outside];
    const Number t = a.clip.z / (a.clip.z - b.clip.z);
    ClippedCorner<Number> corner{{}, inside, outside, t};
    ClipVertex<Number> &cut = corner.vertex;
    cut.clip = {between(a.clip.x, b.clip.x, t), between(a.clip.y, b.clip.y, t), Number(0), wAtNear};
    cut.place = between(a.place, b.place, t);
    cut.normal = between(a.normal, b.normal, t);
    for (std::size_t i = 0; i < cut.texture.size(); ++i)
        cut.texture[i] = between(a.texture[i], b.texture[i], t);
    for (std::size_t i = 0; i < cut.levels.size(); ++i)
        cut.levels[i] = between(a.levels[i], b.levels[i], t);
    return corner;
}

/// The part of a convex polygon at or beyond the near plane, edge by edge [Sutherland 1974]. Only
/// this plane is needed: beyond it w > 0, and the frame's rows and columns clip the rest. A vertex
/// on the plane is itself a corner: its edges are not cut there again.
template <class Number>
void clipAtNear(const std::vector<ClipVertex<Number>> &polygon, const Number &wAtNear,
                std::vector<ClippedCorner<Number>> &clipped)
{
    clipped.clear();
    for (std::size_t from = 0; from < polygon.size(); ++from) {
        const std::size_t to = (from + 1) % polygon.size();
        const bool staysInside = polygon[from].isInside();
        const bool endsInside = polygon[to].isInside();
        if (staysInside)
            clipped.push_back({polygon[from], from, from, Number(0)});
        const std::size_t inside = staysInside ? from : to;
        if (staysInside != endsInside && !polygon[inside].isOnPlane())
            clipped.push_back(cutEdge(polygon, inside, staysInside ? to : from, wAtNear));
    }
}

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
