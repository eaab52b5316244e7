// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/contender.h"

#include "core/scan/choicenames.h"

namespace pixelplumb {

QString Contender::name() const
{
    if (isTruth())
        return u"truth "_s + nameText(nameOf(settings.fillRule));
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

Primitives aloneOf(const Primitives &primitives, std::size_t index)
{
    Primitives one;
    one.appearance = primitives.appearance;
    if (!primitives.isTriangle(index)) {
        one.shapes = {primitives.shape(index)};
        return one;
    }
    one.triangles = {primitives.triangles[index]};
    if (const TriangleAttributes *attributes = primitives.attributesOf(index)) {
        one.attributes = {*attributes};
        one.attributes[0].triangle = 0;
    }
    return one;
}

} // namespace pixelplumb
