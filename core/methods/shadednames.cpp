// SPDX-License-Identifier: GPL-3.0-or-later
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

QString alongRowsText()
{
    return QStringLiteral("((%₁ − %₀)·(y₂ − y₀) − (%₂ − %₀)·(y₁ − y₀))/((x₁ − x₀)·(y₂ − y₀) − "
                          "(x₂ − x₀)·(y₁ − y₀))");
}

QString alongColumnsText()
{
    return QStringLiteral("((%₂ − %₀)·(x₁ − x₀) − (%₁ − %₀)·(x₂ − x₀))/((x₁ − x₀)·(y₂ − y₀) − "
                          "(x₂ − x₀)·(y₁ − y₀))");
}

QString unitOf(Channel channel) { return isLevel(channel) ? unit::levels() : QString(); }

} // namespace pixelplumb
