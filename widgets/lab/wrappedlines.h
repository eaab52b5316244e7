// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

namespace pixelplumb {

/// Lines of at most so many logical pixels: broken between words, and within those that are longer.
QStringList wrappedLines(const QString &text, const QFont &font, double width);

} // namespace pixelplumb
