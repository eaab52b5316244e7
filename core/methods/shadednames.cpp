// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/interpolationnames.h"
#include "core/methods/shadednumbers.h"
#include "core/methods/units.h"

namespace pixelplumb {

const QString &shadedName(Channel channel)
{
    static const PerChannel<QString> names = {
        QStringLiteral("R"),   QStringLiteral("G"),   QStringLiteral("B"),   QStringLiteral("A"),
        QStringLiteral("z"),   QStringLiteral("q"),   QStringLiteral("u"),   QStringLiteral("v"),
        QStringLiteral("N_x"), QStringLiteral("N_y"), QStringLiteral("N_z"), QStringLiteral("p_x"),
        QStringLiteral("p_y"), QStringLiteral("p_z")};
    return names[indexOf(channel)];
}

QString linearName(Channel channel, const EffectSet &effects)
{
    const QString &name = shadedName(channel);
    return effects.perspective && followsPerspective(channel)
        ? withSubscript(name, QStringLiteral("w"))
        : name;
}

QString planeSlope(QChar axis) { return planeSlope(axis, u'(' + doubledAreaText() + u')'); }

QString unitOf(Channel channel) { return isLevel(channel) ? unit::levels() : QString(); }

} // namespace pixelplumb
