// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shape.h"

#include <algorithm>

namespace pixelplumb {

const TriangleSource *Primitives::sourceOf(std::size_t triangle) const
{
    const std::size_t first = triangles.size() - sources.size();
    return triangle >= first && triangle < triangles.size() ? &sources[triangle - first] : nullptr;
}

const TriangleAttributes *Primitives::attributesOf(std::size_t triangle) const
{
    const auto found
        = std::ranges::lower_bound(attributes, triangle, {}, &TriangleAttributes::triangle);
    return found != attributes.end() && found->triangle == triangle ? &*found : nullptr;
}

QString nameOf(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return QStringLiteral("triangle");
    case PrimitiveKind::Point:
        return QStringLiteral("point");
    case PrimitiveKind::Line:
        return QStringLiteral("line");
    case PrimitiveKind::Circle:
        return QStringLiteral("circle");
    case PrimitiveKind::Ellipse:
        return QStringLiteral("ellipse");
    case PrimitiveKind::Bezier:
        return QStringLiteral("bezier");
    case PrimitiveKind::Polygon:
        return QStringLiteral("polygon");
    case PrimitiveKind::Text:
        return QStringLiteral("text");
    }
    return {};
}

} // namespace pixelplumb
