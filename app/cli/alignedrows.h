// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <functional>
#include <vector>

namespace pixelplumb::cli {

/// The rows of a table, each of as many cells, as lines with their columns aligned, two blanks
/// apart: columns of words to the left, those of numbers to the right. No line ends in blanks.
QStringList alignedRows(const std::vector<QStringList> &rows,
                        const std::function<bool(qsizetype column)> &holdsWords);

} // namespace pixelplumb::cli
