// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <QByteArray>

namespace pixelplumb {

/// A primitive as one line of a scene file; what readScene reads back as the same primitive.
QByteArray primitiveText(const Triangle &triangle);
QByteArray primitiveText(const Shape &shape);

/// "[26, "53/2"]".
QByteArray jsonPointText(const LatticePoint &position);

/// A text between quotation marks, as JSON has it.
QByteArray quotedText(const QByteArray &utf8);

} // namespace pixelplumb
