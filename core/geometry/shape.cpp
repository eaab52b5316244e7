// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shape.h"

#include <algorithm>
#include <array>

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
    static constexpr std::array names
        = {QT_TRANSLATE_NOOP("core", "triangle"), QT_TRANSLATE_NOOP("core", "point"),
           QT_TRANSLATE_NOOP("core", "line"),     QT_TRANSLATE_NOOP("core", "circle"),
           QT_TRANSLATE_NOOP("core", "ellipse"),  QT_TRANSLATE_NOOP("core", "bezier"),
           QT_TRANSLATE_NOOP("core", "polygon"),  QT_TRANSLATE_NOOP("core", "text")};
    static_assert(names.size() == std::size_t(PrimitiveKind::Text) + 1);
    return QString::fromUtf8(names[std::size_t(kind)]);
}

} // namespace pixelplumb
