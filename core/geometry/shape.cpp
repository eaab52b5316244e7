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
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "triangle"));
    case PrimitiveKind::Point:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "point"));
    case PrimitiveKind::Line:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "line"));
    case PrimitiveKind::Circle:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "circle"));
    case PrimitiveKind::Ellipse:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "ellipse"));
    case PrimitiveKind::Bezier:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "bezier"));
    case PrimitiveKind::Polygon:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "polygon"));
    case PrimitiveKind::Text:
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "text"));
    }
    return {};
}

} // namespace pixelplumb
