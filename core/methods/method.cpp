// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

QString spanRuleReason(SpanAxis axis)
{
    return u"a %1 ends at its two bounds whatever edge they belong to"_s.arg(
        axis == SpanAxis::Row ? u"row"_s : u"column"_s);
}

bool Method::supports(Arithmetic arithmetic) const
{
    return std::ranges::find(arithmetics, arithmetic) != arithmetics.end();
}

bool Method::supports(FillRule rule) const
{
    return std::ranges::find(fillRules, rule) != fillRules.end();
}

bool Method::supports(Effect effect) const
{
    return std::ranges::find(effects, effect) != effects.end();
}

bool Method::shadesIn(Arithmetic arithmetic) const
{
    return shadingArithmetics.empty()
        || std::ranges::find(shadingArithmetics, arithmetic) != shadingArithmetics.end();
}

bool Method::supports(Variant variant) const
{
    return std::ranges::find(variants, variant) != variants.end();
}

bool Method::walksEdges() const
{
    return spanAxis != SpanAxis::Free && supports(Variant::NoEdgePreStep);
}

bool Method::draws(PrimitiveKind kind) const
{
    return std::ranges::find(kinds, kind) != kinds.end();
}

bool Method::draws(const Shape &shape) const
{
    return draws(shape.kind)
        && (fills.empty() || std::ranges::find(fills, shape.fill) != fills.end());
}

bool Method::isStableIn(Arithmetic arithmetic) const
{
    return std::ranges::find(stableArithmetics, arithmetic) != stableArithmetics.end();
}

QString titleOf(MethodFamily family)
{
    static constexpr std::array names = {QT_TRANSLATE_NOOP("core", "Triangles"),
                                         QT_TRANSLATE_NOOP("core", "Triangles, stable forms"),
                                         QT_TRANSLATE_NOOP("core", "Interpolation"),
                                         QT_TRANSLATE_NOOP("core", "Lines"),
                                         QT_TRANSLATE_NOOP("core", "Curves"),
                                         QT_TRANSLATE_NOOP("core", "Polygons"),
                                         QT_TRANSLATE_NOOP("core", "Points and text")};
    static_assert(names.size() == std::size_t(MethodFamily::Others) + 1);
    return QString::fromUtf8(names[std::size_t(family)]);
}

const Method *methodNamed(QStringView id)
{
    const auto found
        = std::ranges::find_if(methods(), [id](const Method &method) { return method.id == id; });
    return found != methods().end() ? &*found : nullptr;
}

const Method &firstMethodFor(PrimitiveKind kind)
{
    const auto found = std::ranges::find_if(
        methods(), [kind](const Method &method) { return method.draws(kind); });
    return found != methods().end() ? *found : methods().front();
}

const Method &firstMethodFor(const Shape &shape)
{
    const auto found = std::ranges::find_if(
        methods(), [&shape](const Method &method) { return method.draws(shape); });
    return found != methods().end() ? *found : methods().front();
}

const Method &firstMethodFor(const Shape &shape, const Appearance &appearance)
{
    const auto found = std::ranges::find_if(methods(), [&](const Method &method) {
        return method.draws(shape) && method.objection(shape, appearance, {}).isEmpty();
    });
    return found != methods().end() ? *found : firstMethodFor(shape);
}

} // namespace pixelplumb
