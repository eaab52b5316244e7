// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/spacevector.h"

#include <QString>

#include <array>
#include <functional>

/// Formulas of vectors, by component.
namespace pixelplumb {

inline constexpr std::array<QChar, 3> spaceAxes = {u'x', u'y', u'z'};

/// The formula of a vector's component on an axis. Sums and differences are in parentheses.
using Component = std::function<QString(QChar axis)>;

/// "x_N/√(x_N² + y_N² + z_N²)": the components of a normalized vector; "0" where it has no length.
Component unitOf(const SpaceVector<double> &unit, const Component &component);

/// "up_y·back_z − up_z·back_y": a component of the cross product of two vectors.
QString crossFormula(const Component &a, const Component &b, QChar axis);

/// "V₀_x + V₁_x + V₂_x": the sum of a number over `count` vertices; empty where it is too long for
/// a line.
QString sumOverVertices(std::size_t count, const QString &number);

/// "1/3·(V₀_x + V₁_x + V₂_x)".
Component meanOverVertices(std::size_t count);

/// Twice a face's area vector, as a sum over its fan; empty where that is too long for a line.
QString fanFormula(std::size_t count, QChar axis);

} // namespace pixelplumb
