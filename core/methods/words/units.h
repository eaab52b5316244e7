// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// The units of numbers as tables write them.
namespace pixelplumb::unit {

inline QString px() { return QStringLiteral("px"); }
inline QString squarePx() { return QStringLiteral("px²"); }
inline QString levels() { return QStringLiteral("levels"); }

} // namespace pixelplumb::unit
