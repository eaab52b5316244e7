// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/contender.h"

#include "core/scan/choicenames.h"

namespace pixelplumb {

QString Contender::name() const
{
    if (isTruth())
        return QStringLiteral("truth ") + nameText(nameOf(settings.fillRule));
    const QStringList words
        = {method->id, nameText(nameOf(settings.arithmetic)), nameText(nameOf(settings.fillRule))};
    return (words + namesOf(variantsIn(settings.variants))).join(u' ');
}

Contender contenderFor(const Method &method, const ScanSettings &wanted)
{
    return {&method, method.adapted(wanted)};
}

Scene sceneFor(const Scene &scene, const Contender &contender)
{
    Scene drawn = scene;
    if (contender.isTruth())
        return drawn;
    drawn.method = contender.method->id.toStdString();
    drawn.settings = contender.settings;
    return drawn;
}

Primitives primitivesFor(const Primitives &primitives, const Contender &contender)
{
    if (contender.isTruth())
        return primitives;
    Primitives drawn;
    drawn.appearance = primitives.appearance;
    if (contender.method->draws(PrimitiveKind::Triangle)) {
        drawn.triangles = primitives.triangles;
        drawn.attributes = primitives.attributes;
        drawn.sources = primitives.sources;
        drawn.wExponent = primitives.wExponent;
    }
    for (const Shape &shape : primitives.shapes) {
        if (contender.method->draws(shape))
            drawn.shapes.push_back(shape);
    }
    return drawn;
}

} // namespace pixelplumb
