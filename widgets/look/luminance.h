// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace pixelplumb {

/// Relative, as WCAG 2.1 has it: 0 of black, 1 of white.
double luminance(const QColor &colour);

} // namespace pixelplumb
