// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/spacevector.h"

#include <QString>

#include <array>
#include <functional>

/// Formulas of vectors, component by component.
namespace pixelplumb {

inline constexpr std::array<QChar, 3> spaceAxes = {u'x', u'y', u'z'};

/// A component of a vector, by its axis. A sum or a difference stands in parentheses.
using Component = std::function<QString(QChar axis)>;

/// "x_N/√(x_N² + y_N² + z_N²)": of a vector that is made of length 1; 0 where it has no length.
Component unitOf(const SpaceVector<double> &unit, const Component &component);

/// "up_y·back_z − up_z·back_y": of the cross product of two vectors.
QString crossFormula(const Component &a, const Component &b, QChar axis);

/// "V₀_x + V₁_x + V₂_x": the sum of a number over so many vertices; empty where they are too many
/// for a line.
QString sumOverVertices(std::size_t count, const QString &number);

/// "1/3·(V₀_x + V₁_x + V₂_x)".
Component meanOverVertices(std::size_t count);

/// Twice the area vector of a face, as a sum over its fan; empty where that is too long for a line.
QString fanFormula(std::size_t count, QChar axis);

} // namespace pixelplumb
