// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

namespace pixelplumb {

/// Breaks a text into lines of at most `width` logical pixels, between words, and within words that
/// are longer.
QStringList wrappedLines(const QString &text, const QFont &font, double width);

} // namespace pixelplumb
