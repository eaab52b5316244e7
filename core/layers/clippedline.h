// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QRectF>

#include <optional>

namespace pixelplumb {

/// The part of a line that lies in a rectangle; painters lose precision far outside.
std::optional<QLineF> clipped(const QLineF &line, const QRectF &rect);

} // namespace pixelplumb
