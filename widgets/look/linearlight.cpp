// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/linearlight.h"

#include <cmath>

namespace pixelplumb {

double linearLight(double level)
{
    return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
}

double luminance(const QColor &colour)
{
    return 0.2126 * linearLight(colour.redF()) + 0.7152 * linearLight(colour.greenF())
        + 0.0722 * linearLight(colour.blueF());
}

} // namespace pixelplumb
