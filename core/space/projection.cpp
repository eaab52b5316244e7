// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/projection.h"

#include "core/space/attributenumber.h"

#include <cmath>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// Sets attributes, and remembers whether one did not fit.
class AttributeSetter {
public:
    void set(Attribute &attribute, double value)
    {
        if (const auto nearest = nearestAttribute(value))
            attribute = *nearest;
        else
            m_fits = false;
    }
    void set(std::array<Attribute, 3> &attributes, const SpaceVector<double> &vector)
    {
        set(attributes[0], vector.x);
        set(attributes[1], vector.y);
        set(attributes[2], vector.z);
    }
    bool fits() const { return m_fits; }

private:
    bool m_fits = true;
};

/// Collects the triangles of faces.
class TriangleCollector {
public:
    TriangleCollector(ProjectedSolids &projected, int material)
        : m_projected(projected)
        , m_material(material)
    {
    }

    void append(TriangleSource source, const ProjectedFace<double> &face)
    {
        if (face.clipped.size() < 3) {
            m_projected.lost.push_back({source, ProjectionLoss::BehindNearPlane});
            return;
        }
        m_isCut = !std::ranges::all_of(face.polygon, &ClipVertex<double>::isInside);
        m_corners.clear();
        for (std::size_t i = 0; i < face.clipped.size(); ++i) {
            m_corners.push_back(
                snapped(face.clipped[i], face.places[i], face.devices[i].z, m_projected.wExponent));
        }
        for (std::size_t i = 2; i < m_corners.size(); ++i) {
            source.piece = std::uint32_t(i - 2);
            append(source, {&m_corners[0], &m_corners[i - 1], &m_corners[i]});
        }
    }

private:
    void append(const TriangleSource &source, const std::array<const SnappedCorner *, 3> &corners)
    {
        for (const SnappedCorner *corner : corners) {
            if (corner->loss) {
                m_projected.lost.push_back({source, *corner->loss});
                return;
            }
        }
        Triangle triangle;
        TriangleAttributes attributes{m_projected.triangles.size(), {}, m_material};
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.vertices[i] = corners[i]->vertex;
            attributes.vertices[i] = corners[i]->attributes;
        }
        if (m_isCut)
            m_projected.cutAtNear.push_back(m_projected.triangles.size());
        m_projected.triangles.push_back(triangle);
        m_projected.attributes.push_back(attributes);
        m_projected.sources.push_back(source);
    }

    ProjectedSolids &m_projected;
    int m_material;
    bool m_isCut = false; ///< the current face
    std::vector<SnappedCorner> m_corners;
};

/// The largest view depth of a vertex.
double deepest(const SpaceScene &scene)
{
    const CameraTransform<double> camera(scene.camera, scene.frame);
    double deepest = 0;
    for (const Solid &solid : scene.solids) {
        const SolidVertices<double> vertices(solid);
        for (std::size_t i = 0; i < vertexCount(solid); ++i)
            deepest = std::max(deepest, -camera.toView(vertices.vertex(i).position).z);
    }
    return deepest;
}

} // namespace

QString nameOf(ProjectionLoss loss)
{
    switch (loss) {
    case ProjectionLoss::NoView:
        return QStringLiteral(QT_TRANSLATE_NOOP(
            "core", "is not seen: the camera's eye is at its target, or up is where it looks"));
    case ProjectionLoss::BehindNearPlane:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "has no part beyond the near plane"));
    case ProjectionLoss::NotFinite:
        return QStringLiteral(
            QT_TRANSLATE_NOOP("core", "has a corner that the camera takes nowhere"));
    case ProjectionLoss::OutsideCoordinates:
        return u"has a corner beyond ±2^30 px"_s;
    case ProjectionLoss::OutsideAttributes:
        return u"has a corner with a number beyond ±2^20"_s;
    }
    return {};
}

int wExponentOf(const SpaceScene &scene)
{
    if (scene.camera.projection == Projection::Orthographic)
        return 0;
    const double depth = std::max(deepest(scene), scene.camera.near);
    if (!std::isfinite(depth) || !(scene.camera.near > 0))
        return 0;
    // ⌈log₂ depth⌉ and ⌊log₂ near⌋.
    int exponent = 0;
    const int deepestBits = std::frexp(depth, &exponent) == 0.5 ? exponent - 1 : exponent;
    const int nearBits = std::ilogb(scene.camera.near);
    constexpr int mostBits = 20;
    return std::min(std::max(0, -nearBits), mostBits - deepestBits);
}

SnappedCorner snapped(const ClippedCorner<double> &corner, const std::array<double, 2> &place,
                      double z, int wExponent)
{
    const ClipVertex<double> &from = corner.vertex;
    SnappedCorner to;
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) {
        to.loss = ProjectionLoss::NotFinite;
        return to;
    }
    const auto x = nearestLattice(place[0]);
    const auto y = nearestLattice(place[1]);
    if (!x || !y) {
        to.loss = ProjectionLoss::OutsideCoordinates;
        return to;
    }
    to.vertex
        = {{*x, *y},
           {{levelByte(from.levels[0]), levelByte(from.levels[1]), levelByte(from.levels[2])}}};
    VertexAttributes &attributes = to.attributes;
    AttributeSetter setter;
    setter.set(attributes.z, z);
    setter.set(attributes.w, std::ldexp(from.clip.w, wExponent));
    attributes.w = std::max(attributes.w, Attribute(1));
    for (std::size_t i = 0; i < 2; ++i)
        setter.set(attributes.texture[i], from.texture[i]);
    setter.set(attributes.normal, from.normal);
    setter.set(attributes.place, from.place);
    attributes.alpha = levelByte(from.levels[3]);
    if (!setter.fits())
        to.loss = ProjectionLoss::OutsideAttributes;
    return to;
}

std::optional<ProjectedSolids> projectSolids(const SpaceScene &scene,
                                             const ProgressListener &listener)
{
    constexpr std::int64_t facesBetweenProgress = 256;
    ProjectedSolids projected;
    projected.wExponent = wExponentOf(scene);
    std::size_t count = 0;
    for (const Solid &solid : scene.solids)
        count += faceCount(solid);
    projected.triangles.reserve(count);
    projected.attributes.reserve(count);
    projected.sources.reserve(count);
    std::int64_t done = 0;
    const bool hasView = !CameraTransform<double>(scene.camera, scene.frame).right().isZero();
    for (std::size_t i = 0; i < scene.solids.size(); ++i) {
        const Solid &solid = scene.solids[i];
        if (solid.isHidden)
            continue;
        if (!hasView) {
            projected.lost.push_back({{std::uint32_t(i), 0, 0}, ProjectionLoss::NoView});
            continue;
        }
        FaceProjector<double> projector(scene, solid);
        TriangleCollector triangles(projected, solid.material);
        for (std::size_t face = 0; face < faceCount(solid); ++face, ++done) {
            if (done % facesBetweenProgress == 0
                && !goesOn(listener, {JobPhase::Projecting, done, std::int64_t(count)}))
                return std::nullopt;
            triangles.append({std::uint32_t(i), std::uint32_t(face), 0}, projector.project(face));
        }
    }
    return projected;
}

Appearance viewedBy(const Camera &camera, Appearance appearance)
{
    const SpaceVector<double> eye(camera.eye);
    const bool isPlace = camera.projection == Projection::Perspective;
    const SpaceVector<double> viewer
        = isPlace ? eye : unit(eye - SpaceVector<double>(camera.target));
    appearance.viewerKind = isPlace ? Light::Kind::Positional : Light::Kind::Directional;
    appearance.viewer
        = {clampedAttribute(viewer.x), clampedAttribute(viewer.y), clampedAttribute(viewer.z)};
    return appearance;
}

} // namespace pixelplumb
