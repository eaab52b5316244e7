// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/idlesetting.h"

#include "core/methods/method.h"
#include "core/plan/requirements.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether a shape's levels are its vertices' bytes: only a line has levels between its two ends'.
bool hasWholeLevels(const Shape &shape)
{
    return shape.kind != PrimitiveKind::Line
        || shape.vertices.front().colour == shape.vertices.back().colour;
}

/// Whether the method draws something of the scene and none of its levels lies between two bytes.
bool drawsWholeLevels(const Method &method, const Scene &scene)
{
    const bool hasTriangles = !scene.triangles.empty() || !scene.solids.empty();
    if (hasTriangles && method.draws(PrimitiveKind::Triangle))
        return false;
    if (method.supports(Effect::Antialiasing)
        && antialiasingOf(scene.appearance) != Antialiasing::None)
        return false;
    const auto isDrawn = [&method](const Shape &shape) { return method.draws(shape); };
    return std::ranges::any_of(scene.shapes, isDrawn)
        && std::ranges::all_of(scene.shapes, [&](const Shape &shape) {
               return !isDrawn(shape) || hasWholeLevels(shape);
           });
}

} // namespace

QString idleReason(DrawingSetting setting, const Scene &scene)
{
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    if (!method)
        return {};
    switch (setting) {
    case DrawingSetting::Arithmetic:
        if (method->arithmetics.size() == 1)
            return u"computes in “%1” alone"_s.arg(nameText(nameOf(method->arithmetics.front())));
        break;
    case DrawingSetting::FillRule:
        if (method->fillRules.size() == 1)
            return u"keeps the fill rule “%1” alone: %2"_s.arg(
                nameText(nameOf(method->fillRules.front())), method->fillRuleReason);
        break;
    case DrawingSetting::Rounding:
        if (drawsWholeLevels(*method, scene))
            return u"paints each of these primitives in one colour: no level lies "
                   "between two bytes"_s;
        break;
    }
    return {};
}

} // namespace pixelplumb
