// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/spacescenes.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

double distanceFromSegment(const Vertex &a, const Vertex &b, double x, double y)
{
    const double dx = double(b.position.x - a.position.x) / 256;
    const double dy = double(b.position.y - a.position.y) / 256;
    const double px = x - double(a.position.x) / 256;
    const double py = y - double(a.position.y) / 256;
    const double length = dx * dx + dy * dy;
    const double t = length == 0 ? 0 : std::clamp((px * dx + py * dy) / length, 0.0, 1.0);
    return std::hypot(px - t * dx, py - t * dy);
}

} // namespace

Scene sceneOf(std::vector<Solid> solids)
{
    Scene scene;
    scene.frame.width = 100;
    scene.frame.height = 80;
    scene.camera = Camera();
    scene.solids = std::move(solids);
    return scene;
}

SolidCorner cornerAt(const Vector3 &position)
{
    SolidCorner corner;
    corner.position = position;
    return corner;
}

Solid triangle3(const Vector3 &a, const Vector3 &b, const Vector3 &c)
{
    Solid solid;
    solid.corners = {cornerAt(a), cornerAt(b), cornerAt(c)};
    return solid;
}

Solid solidOf(SolidKind kind)
{
    Solid solid;
    solid.kind = kind;
    solid.segments = {13, 7};
    if (kind == SolidKind::Sphere) {
        solid.corners = {cornerAt({})};
    } else if (kind == SolidKind::Patch) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                const double bulge = (i == 1 || i == 2) && (j == 1 || j == 2) ? 2 : 0.1 * i * j;
                solid.corners.push_back(cornerAt({j / 1.5 - 1, i / 1.5 - 1, bulge}));
            }
        }
    } else {
        auto mesh = std::make_shared<Mesh>();
        for (const double side : {1.0, -1.0}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Vector3 tip = {};
                tip[axis] = side;
                mesh->corners.push_back(cornerAt(tip));
            }
        }
        // One face per octant; an odd number of negative sides reverses its winding.
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const std::uint32_t x = octant & 1U;
            const std::uint32_t y = octant >> 1U & 1U;
            const std::uint32_t z = octant >> 2U;
            std::array<std::uint32_t, 3> face = {3 * x, 3 * y + 1, 3 * z + 2};
            if ((x + y + z) % 2 == 1)
                std::swap(face[1], face[2]);
            mesh->faces.push_back(face);
        }
        solid.mesh = mesh;
        solid.rotate = {10, 20, 30};
        solid.at = {0.1, -0.1, 0.2};
    }
    return solid;
}

double distanceFrom(const std::vector<Triangle> &triangles, double x, double y)
{
    double nearest = 1e9;
    for (const Triangle &triangle : triangles) {
        int left = 0;
        int right = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex &a = triangle.vertices[i];
            const Vertex &b = triangle.vertices[(i + 1) % 3];
            nearest = std::min(nearest, distanceFromSegment(a, b, x, y));
            const double side
                = double(b.position.x - a.position.x) * (y * 256 - double(a.position.y))
                - double(b.position.y - a.position.y) * (x * 256 - double(a.position.x));
            left += side >= 0 ? 1 : 0;
            right += side <= 0 ? 1 : 0;
        }
        if (left == 3 || right == 3)
            return 0;
    }
    return nearest;
}

double doubledAreaInPixels(const Vector3 &a, const Vector3 &b, const Vector3 &c)
{
    return ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) * 20 * 20;
}

std::map<std::pair<LatticePoint, LatticePoint>, int> openEdges(
    const std::vector<Triangle> &triangles)
{
    std::map<std::pair<LatticePoint, LatticePoint>, int> edges;
    for (const Triangle &triangle : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &from = triangle.vertices[i].position;
            const LatticePoint &to = triangle.vertices[(i + 1) % 3].position;
            if (from < to)
                ++edges[{from, to}];
            else if (to < from)
                --edges[{to, from}];
        }
    }
    std::erase_if(edges, [](const auto &edge) { return edge.second == 0; });
    return edges;
}

std::set<LatticePoint> bordersOf(const Solid &solid, const Scene &scene)
{
    std::set<LatticePoint> border;
    if (solid.kind != SolidKind::Patch)
        return border;
    const ProjectedSolids projected = projectedSolids(scene);
    for (std::size_t i = 0; i < projected.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &[u, v] = projected.attributes[i].vertices[k].texture;
            if (u == 0 || v == 0 || u == attributeOne || v == attributeOne)
                border.insert(projected.triangles[i].vertices[k].position);
        }
    }
    return border;
}

} // namespace pixelplumb
