// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <functional>
#include <vector>

namespace pixelplumb::cli {

/// Formats a table as lines with aligned columns, two blanks apart: words to the left, numbers to
/// the right. All rows have equally many cells. No line ends in blanks.
QStringList alignedRows(const std::vector<QStringList> &rows,
                        const std::function<bool(qsizetype column)> &holdsWords);

} // namespace pixelplumb::cli
