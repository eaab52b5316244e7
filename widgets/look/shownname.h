// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// The name of a file as titles, labels and menus show it: shortened where it is very long,
/// unprintable characters as their codes.
QString shownName(const QString &path);

} // namespace pixelplumb
