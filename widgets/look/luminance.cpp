// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/luminance.h"

#include "core/frame/srgb.h"

namespace pixelplumb {

double luminance(const QColor &colour)
{
    return 0.2126 * linearLight(colour.redF()) + 0.7152 * linearLight(colour.greenF())
        + 0.0722 * linearLight(colour.blueF());
}

} // namespace pixelplumb
