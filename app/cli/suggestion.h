// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace pixelplumb::cli {

/// The candidate that someone who wrote `word` most likely meant: few letters left out, added,
/// changed or swapped with their neighbour. Empty when none is near.
QString closestTo(const QString &word, const QStringList &candidates);

/// "; did you mean render?", or nothing.
QString suggestion(const QString &word, const QStringList &candidates);

} // namespace pixelplumb::cli
