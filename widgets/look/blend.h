// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace pixelplumb {

/// `base` with a share (0 … 1) of `tint` mixed in, channel by channel.
inline QColor blended(const QColor &base, const QColor &tint, float share)
{
    const auto mix = [share](float from, float to) { return from + (to - from) * share; };
    return QColor::fromRgbF(mix(base.redF(), tint.redF()), mix(base.greenF(), tint.greenF()),
                            mix(base.blueF(), tint.blueF()));
}

} // namespace pixelplumb
