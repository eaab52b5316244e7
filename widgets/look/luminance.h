// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace pixelplumb {

/// The relative luminance of WCAG 2.1: 0 for black, 1 for white.
double luminance(const QColor &colour);

} // namespace pixelplumb
