// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

/// The sRGB transfer curve (IEC 61966-2-1) between a channel's level and its light, both from 0 to
/// 1.
namespace pixelplumb {

inline double linearLight(double level)
{
    return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
}

inline double levelOfLight(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

} // namespace pixelplumb
