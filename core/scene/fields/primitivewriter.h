// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/hiddenprimitive.h"

#include <QByteArray>

#include <span>

namespace pixelplumb {

/// A primitive as one line of a scene file, which readScene() reads back as the same primitive.
/// `attributes` is null for a triangle without any.
QByteArray primitiveText(const Triangle &triangle, const TriangleAttributes *attributes,
                         const std::vector<Material> &materials);
QByteArray primitiveText(const Shape &shape);
/// Adds the key "hidden".
QByteArray primitiveText(const HiddenPrimitive &hidden, const std::vector<Material> &materials);

/// "[26, "53/2"]".
QByteArray jsonPointText(const LatticePoint &position);

/// "1", or ""1/3"".
QByteArray jsonAttributeText(Attribute value);
/// "[1, "1/3"]".
QByteArray jsonAttributeText(std::span<const Attribute> values);

/// The shortest decimal for the same double.
QByteArray jsonRealText(double value);
/// "[1, 0.5]".
QByteArray jsonRealsText(std::span<const double> values);

/// A text in quotation marks, escaped for JSON.
QByteArray quotedText(const QByteArray &utf8);

} // namespace pixelplumb
