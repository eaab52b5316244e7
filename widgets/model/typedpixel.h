// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QString>

#include <optional>

namespace pixelplumb {

/// Reads a typed pixel: "27 19", "27, 19", "27; 19" or "(27, 19)".
std::optional<QPoint> typedPixel(const QString &text);

} // namespace pixelplumb
