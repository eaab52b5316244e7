// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace pixelplumb {

/// The light of a channel's level in sRGB (IEC 61966-2-1); both from 0 to 1.
double linearLight(double level);

/// Relative, as WCAG 2.1 has it: 0 of black, 1 of white.
double luminance(const QColor &colour);

} // namespace pixelplumb
