// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/shading/shadednumbers.h"

namespace pixelplumb {

const QString &shadedName(Channel channel)
{
    static const PerChannel<QString> names
        = {"R", "G", "B", "A", "z", "q", "u", "v", "N_x", "N_y", "N_z", "p_x", "p_y", "p_z"};
    return names[indexOf(channel)];
}

ShadedScope interpolationScope(InterpolationForm form, const CarriedChannels &carried)
{
    using enum Channel;
    ShadedScope scope;
    scope.form = form;
    scope.effects.smooth = true;
    scope.isPlanned = false;
    const auto append = [&](std::initializer_list<Channel> channels) {
        for (const Channel channel : channels)
            scope.channels.push_back({scope.channels.size(), channel});
    };
    append({Red, Green, Blue});
    if (carried.depth)
        append({Depth});
    if (carried.texture)
        append({U, V});
    if (carried.normal)
        append({NormalX, NormalY, NormalZ});
    return scope;
}

QString linearName(Channel channel, const EffectSet &effects)
{
    const QString &name = shadedName(channel);
    return effects.perspective && followsPerspective(channel) ? withSubscript(name, "w") : name;
}

QString planeSlope(QChar axis) { return planeSlope(axis, u'(' + doubledAreaText() + u')'); }

QString unitOf(Channel channel, const QString &per)
{
    return isLevel(channel) ? u"levels"_s + per : QString();
}

} // namespace pixelplumb
