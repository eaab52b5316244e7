// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QStringList>

namespace pixelplumb::cli {

/// The candidate that someone who wrote `word` most likely meant: few letters left out, added,
/// changed or swapped with their neighbour. Empty when none is near.
QString closestTo(const QString &word, const QStringList &candidates);

/// "; did you mean render?", or nothing.
QString suggestion(const QString &word, const QStringList &candidates);

/// The error of a word that is none of the names; `what` it should have named: "arithmetic".
InputError unknownName(const QString &place, const QString &what, const QString &word,
                       const QStringList &names);

/// The same where there are so many names that the nearest alone are named; `expected` says what
/// else there is.
InputError unknownAmongMany(const QString &place, const QString &what, const QString &word,
                            const QStringList &names, const QString &expected);

} // namespace pixelplumb::cli
