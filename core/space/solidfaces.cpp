// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/solidfaces.h"

namespace pixelplumb {

namespace {

std::size_t around(const Solid &solid) { return std::size_t(solid.segments[0]); }
std::size_t along(const Solid &solid) { return std::size_t(solid.segments[1]); }

/// The index of the grid vertex in column i of row j.
std::size_t gridVertex(const Solid &solid, std::size_t i, std::size_t j)
{
    return j * (around(solid) + 1) + i;
}

void takeSphereFace(const Solid &solid, std::size_t face, std::vector<std::size_t> &vertices)
{
    const std::size_t i = face % around(solid);
    const std::size_t j = face / around(solid);
    const std::size_t upperLeft = gridVertex(solid, i, j);
    const std::size_t lowerLeft = gridVertex(solid, i, j + 1);
    if (j == 0)
        vertices = {upperLeft, lowerLeft, lowerLeft + 1};
    else if (j + 1 == along(solid))
        vertices = {upperLeft, lowerLeft, upperLeft + 1};
    else
        vertices = {upperLeft, lowerLeft, lowerLeft + 1, upperLeft + 1};
}

void takePatchFace(const Solid &solid, std::size_t face, std::vector<std::size_t> &vertices)
{
    const std::size_t cell = face / 2;
    const std::size_t low = gridVertex(solid, cell % around(solid), cell / around(solid));
    const std::size_t high = low + around(solid) + 1;
    if (face % 2 == 0)
        vertices = {low, low + 1, high + 1};
    else
        vertices = {low, high + 1, high};
}

} // namespace

std::size_t faceCount(const Solid &solid)
{
    if (solid.isHidden)
        return 0;
    switch (solid.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
    case SolidKind::Plane:
        return 1;
    case SolidKind::Sphere:
        return around(solid) * along(solid);
    case SolidKind::Patch:
        return 2 * around(solid) * along(solid);
    case SolidKind::Mesh:
        return solid.mesh ? solid.mesh->faces.size() : 0;
    }
    return 0;
}

void takeFace(const Solid &solid, std::size_t face, std::vector<std::size_t> &vertices)
{
    switch (solid.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
    case SolidKind::Plane:
        vertices.resize(vertexCount(solid));
        for (std::size_t i = 0; i < vertices.size(); ++i)
            vertices[i] = i;
        break;
    case SolidKind::Sphere:
        takeSphereFace(solid, face, vertices);
        break;
    case SolidKind::Patch:
        takePatchFace(solid, face, vertices);
        break;
    case SolidKind::Mesh:
        vertices.assign(solid.mesh->faces[face].begin(), solid.mesh->faces[face].end());
        break;
    }
}

std::size_t vertexCount(const Solid &solid)
{
    if (solid.isHidden)
        return 0;
    switch (solid.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
        return solid.corners.size();
    case SolidKind::Plane:
        return 4;
    case SolidKind::Sphere:
    case SolidKind::Patch:
        return (around(solid) + 1) * (along(solid) + 1);
    case SolidKind::Mesh:
        return solid.mesh ? solid.mesh->corners.size() : 0;
    }
    return 0;
}

} // namespace pixelplumb
