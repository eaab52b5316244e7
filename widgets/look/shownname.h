// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// The name of a file at a path as titles, labels and menus show it: shortened where it is very
/// long, what cannot be shown as its code.
QString shownName(const QString &path);

} // namespace pixelplumb
