// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scan/boundaryrule.h"

#include <QStringList>

namespace pixelplumb {

/// Whether the method draws primitives of this one's kind.
bool isDrawn(const Primitives &primitives, std::size_t primitive, const Method &method);

/// The names of the kinds of primitives that the method does not draw, in order of first
/// appearance: "line", "circle (outline)".
QStringList kindsUndrawn(const Primitives &primitives, const Method &method);

/// The undrawn primitives that cover a pixel, in drawing order: "line 1". Sample coordinates.
QStringList undrawnAt(const Primitives &primitives, const Method &method, const BoundaryRule &rule,
                      std::int64_t x, std::int64_t y);

} // namespace pixelplumb
