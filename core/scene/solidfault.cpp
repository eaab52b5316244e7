// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/solidfault.h"

#include "core/geometry/attributes.h"
#include "core/space/polygonshape.h"
#include "core/space/spacevector.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

using namespace Qt::StringLiterals;

using Fault = std::optional<InputError>;

Fault faultOfReach(const Vector3 &centre, double radius)
{
    double reach = 0;
    for (const double coordinate : centre)
        reach = std::max(reach, std::abs(coordinate) + radius);
    if (reach <= double(largestAttributeValue))
        return {};
    return InputError{
        {}, u"it reaches to %1"_s.arg(reach), u"all of it within ±%1"_s.arg(largestAttributeValue)};
}

Fault faultOfPolygon(PolygonShape shape)
{
    switch (shape) {
    case PolygonShape::Convex:
        break;
    case PolygonShape::Flattened:
        return InputError{{}, "corners on one line", "a polygon with an area"};
    case PolygonShape::Bent:
        return InputError{{}, "corners that are not in one plane", "a polygon in one plane"};
    case PolygonShape::Concave:
        return InputError{
            {}, "a polygon that is not convex", "a convex one; others are made of several"};
    }
    return {};
}

} // namespace

std::optional<InputError> faultOf(const Solid &solid)
{
    switch (solid.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Patch:
        break;
    case SolidKind::Polygon3:
        return faultOfPolygon(shapeOf(solid.corners));
    case SolidKind::Plane:
        if (shapeOf(solid.corners) == PolygonShape::Flattened)
            return InputError{{}, "three points on one line", "three that span a plane"};
        break;
    case SolidKind::Sphere:
        return faultOfReach(solid.corners.front().position, solid.radius);
    case SolidKind::Mesh: {
        double radius = 0;
        for (const SolidCorner &corner : solid.mesh->corners)
            radius = std::max(radius, lengthOf(SpaceVector<double>(corner.position)));
        return faultOfReach(solid.at, solid.scale * radius);
    }
    }
    return {};
}

} // namespace pixelplumb
