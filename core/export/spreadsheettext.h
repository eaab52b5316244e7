// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace pixelplumb {

/// A text that somebody else gave, for a cell of a CSV file: no spreadsheet takes it, or a part of
/// it, for a formula. An apostrophe stands before what would begin one, at the start and behind
/// each character that separates cells in some language ("a;=1+1" is two cells in German); what
/// looks like it in full width begins one, too. An apostrophe at such a place is doubled, so that
/// no two texts become the same.
QString spreadsheetText(const QString &text);

} // namespace pixelplumb
