// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/undrawn.h"

#include "core/oracle/oracle.h"
#include "core/oracle/strokeoracle.h"
#include "core/scene/shapenames.h"

#include <algorithm>

namespace pixelplumb {

bool isDrawn(const Primitives &primitives, std::size_t primitive, const Method &method)
{
    return primitives.isTriangle(primitive) ? method.draws(PrimitiveKind::Triangle)
                                            : method.draws(primitives.shape(primitive));
}

namespace {

/// "line"; "circle (outline)" if the method draws circles, but not these.
QString undrawnKind(const Primitives &primitives, std::size_t primitive, const Method &method)
{
    const PrimitiveKind kind = primitives.kindOf(primitive);
    if (!method.draws(kind))
        return nameOf(kind);
    const auto fills = fillNamesOf(kind);
    const auto fill = std::ranges::find(fills, primitives.shape(primitive).fill, &FillName::fill);
    return fill == fills.end() ? nameOf(kind) : u"%1 (%2)"_s.arg(nameOf(kind), QString(fill->name));
}

} // namespace

QStringList kindsUndrawn(const Primitives &primitives, const Method &method)
{
    QStringList kinds;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        if (isDrawn(primitives, i, method))
            continue;
        const QString kind = undrawnKind(primitives, i, method);
        if (!kinds.contains(kind))
            kinds.append(kind);
    }
    return kinds;
}

QStringList undrawnAt(const Primitives &primitives, const Method &method, const BoundaryRule &rule,
                      std::int64_t x, std::int64_t y)
{
    QStringList undrawn;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        if (isDrawn(primitives, i, method))
            continue;
        const bool covers = primitives.isTriangle(i)
            ? oracle::covers(primitives.triangles[i], rule, x, y)
            : oracle::covers(primitives.shape(i), primitives.appearance,
                             oracle::StrokeTruth::NearestPixels, rule.origin, x, y);
        if (covers)
            undrawn.append(u"%1 %2"_s.arg(nameOf(primitives.kindOf(i))).arg(i));
    }
    return undrawn;
}

} // namespace pixelplumb
