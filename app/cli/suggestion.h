// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QStringList>

namespace pixelplumb::cli {

/// The candidate that `word` most likely stands for: a few letters left out, added, changed or
/// swapped with a neighbour. Empty when none is near.
QString closestTo(const QString &word, const QStringList &candidates);

/// "; did you mean render?", or nothing.
QString suggestion(const QString &word, const QStringList &candidates);

/// The error for a word that is none of the names; `what` it should have named: "arithmetic".
InputError unknownName(const QString &place, const QString &what, const QString &word,
                       const QStringList &names);

/// Like unknownName(), but with so many names that only the nearest are listed; `expected` says
/// what else there is.
InputError unknownAmongMany(const QString &place, const QString &what, const QString &word,
                            const QStringList &names, const QString &expected);

} // namespace pixelplumb::cli
