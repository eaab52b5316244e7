// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/scenelimits.h"

#include "core/geometry/attributes.h"
#include "core/geometry/triangle.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

std::size_t triangleCount(const Solid &solid)
{
    const auto around = std::size_t(solid.segments[0]);
    const auto along = std::size_t(solid.segments[1]);
    switch (solid.kind) {
    case SolidKind::Triangle3:
        return 1;
    case SolidKind::Polygon3:
        return solid.corners.size() - 2;
    case SolidKind::Plane:
        return 2;
    case SolidKind::Sphere:
        return 2 * around * (along - 1);
    case SolidKind::Patch:
        return 2 * around * along;
    case SolidKind::Mesh:
        return solid.mesh ? solid.mesh->faces.size() : 0;
    }
    return 0;
}

QString tooManyTriangles(std::size_t count)
{
    constexpr std::size_t bytesOfEach = sizeof(Triangle) + sizeof(TriangleAttributes);
    return u"the scene's solids are cut into %1 triangles, %2 MiB"_s.arg(count).arg(
        count * bytesOfEach >> 20);
}

QString fewerTriangles() { return u"at most %1 triangles"_s.arg(mostSolidTriangles); }

QString tooManyVertices(std::size_t count)
{
    return u"with it the scene's shapes have %1 vertices, %2 for each character of a "
           "text"_s.arg(count)
               .arg(verticesOfCharacter);
}

QString fewerVertices() { return u"at most %1"_s.arg(mostShapeVertices); }

} // namespace pixelplumb
