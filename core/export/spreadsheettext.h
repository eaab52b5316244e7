// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// A text of foreign origin made safe for a CSV cell: no spreadsheet reads it, or a part of it, as
/// a formula. An apostrophe goes before whatever would begin a formula, at the start and after each
/// character that separates cells in some language ("a;=1+1" is two cells in German); full-width
/// look-alikes count too. An apostrophe already at such a place is doubled, so that no two texts
/// become the same.
QString spreadsheetText(const QString &text);

} // namespace pixelplumb
