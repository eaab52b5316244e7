// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/sidescene.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

using Point = SpaceVector<double>;

/// More could not be told apart and take too long to draw.
constexpr std::size_t mostFaces = 1500;

CameraTransform<double> transformOf(const Scene &scene)
{
    return {scene.camera.value_or(Camera()), scene.frame};
}

SideScene::Rectangle frameAt(const CameraTransform<double> &camera, double depth)
{
    const auto [x, y] = camera.halfFrameAt(depth);
    return {Point(-x, -y, -depth), Point(x, -y, -depth), Point(x, y, -depth), Point(-x, y, -depth)};
}

/// Where the ray to a point meets the picture plane.
Point onPicture(const SideScene &side, const Point &point)
{
    const double depth = -point.z;
    const double factor = side.isPerspective ? side.pictureDepth / depth : 1;
    return {factor * point.x, factor * point.y, -side.pictureDepth};
}

/// A bounding box that grows with each point.
class Bounds {
public:
    void include(const Point &point)
    {
        m_low = m_isEmpty ? point
                          : Point(std::min(m_low.x, point.x), std::min(m_low.y, point.y),
                                  std::min(m_low.z, point.z));
        m_high = m_isEmpty ? point
                           : Point(std::max(m_high.x, point.x), std::max(m_high.y, point.y),
                                   std::max(m_high.z, point.z));
        m_isEmpty = false;
    }
    void appendCorners(std::vector<Point> &points) const
    {
        if (m_isEmpty)
            return;
        for (const double x : {m_low.x, m_high.x}) {
            for (const double y : {m_low.y, m_high.y}) {
                for (const double z : {m_low.z, m_high.z})
                    points.push_back({x, y, z});
            }
        }
    }

private:
    Point m_low;
    Point m_high;
    bool m_isEmpty = true;
};

void appendEdges(const Solid &solid, const CameraTransform<double> &camera, std::size_t every,
                 std::vector<std::pair<Point, Point>> &edges)
{
    const SolidVertices<double> vertices(solid);
    std::vector<std::size_t> face;
    for (std::size_t i = 0; i < faceCount(solid); i += every) {
        takeFace(solid, i, face);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::size_t next = face[(k + 1) % face.size()];
            edges.emplace_back(camera.toView(vertices.vertex(face[k]).position),
                               camera.toView(vertices.vertex(next).position));
        }
    }
}

} // namespace

SideScene sideSceneOf(const Scene &scene)
{
    const Camera camera = scene.camera.value_or(Camera());
    const CameraTransform<double> transform = transformOf(scene);
    const double distance = lengthOf(Point(camera.eye) - Point(camera.target));
    SideScene side;
    side.isPerspective = camera.projection == Projection::Perspective;
    side.pictureDepth = std::max(camera.near, distance / 2);
    side.nearPlane = frameAt(transform, camera.near);
    side.picturePlane = frameAt(transform, side.pictureDepth);
    std::size_t faces = 0;
    for (const Solid &solid : scene.solids)
        faces += faceCount(solid);
    const std::size_t every = faces / mostFaces + 1;
    side.showsAllEdges = every == 1;
    Bounds bounds;
    for (const Solid &solid : scene.solids) {
        appendEdges(solid, transform, every, side.edges);
        const SolidVertices<double> vertices(solid);
        for (std::size_t i = 0; i < vertexCount(solid); ++i)
            bounds.include(transform.toView(vertices.vertex(i).position));
    }
    side.outline = {Point()};
    side.outline.insert(side.outline.end(), side.nearPlane.begin(), side.nearPlane.end());
    side.outline.insert(side.outline.end(), side.picturePlane.begin(), side.picturePlane.end());
    bounds.appendCorners(side.outline);
    return side;
}

SideFace sideFaceOf(const Scene &scene, const SideScene &side, const FaceStages &stages,
                    const TriangleSource &source, const std::optional<QPoint> &pixel)
{
    const CameraTransform<double> camera = transformOf(scene);
    SideFace face;
    face.vertices = stages.face.views;
    for (std::size_t i = 0; i < stages.face.clipped.size(); ++i) {
        face.clipped.push_back(camera.toView(stages.face.clipped[i].vertex.place));
        face.picture.push_back(onPicture(side, face.clipped.back()));
        face.colours.push_back(stages.corners[i].vertex.colour);
    }
    face.piece = {0, std::size_t(source.piece) + 1, std::size_t(source.piece) + 2};
    if (!pixel || face.vertices.size() < 3)
        return face;
    const auto [x, y] = camera.deviceAt(pixel->x(), pixel->y());
    const auto &[lowerLeft, lowerRight, upperRight, upperLeft] = side.picturePlane;
    const Point onPlane(upperRight.x * x, upperRight.y * y, -side.pictureDepth);
    const Point from = side.isPerspective ? Point() : Point(onPlane.x, onPlane.y, 0);
    const Point normal
        = cross(face.vertices[1] - face.vertices[0], face.vertices[2] - face.vertices[0]);
    const double slope = dot(normal, onPlane - from);
    const double t = dot(normal, face.vertices[0] - from) / slope;
    if (slope != 0 && std::isfinite(t) && t > 0)
        face.sample = SideFace::Ray{onPlane, from + t * (onPlane - from)};
    return face;
}

} // namespace pixelplumb
