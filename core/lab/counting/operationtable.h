// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operationcounts.h"

#include <QStringList>

#include <vector>

namespace pixelplumb {

/// A line of a résumé as people read it: the operations of one set-up, one span and one sample, on
/// average, and all of them together.
struct OperationTableRow {
    QString name; ///< "divisions"; "all" in the last row
    std::array<double, allWorkStages.size()> each = {}; ///< by WorkStage
    std::int64_t all = 0;
};

/// The kinds that occur, then their sum.
std::vector<OperationTableRow> operationTable(const OperationCounts &counts);

/// "6" or "20.49": two digits after the point unless it is whole.
QString operationText(double each);

/// "1 set-up, 55 spans, 1124 pixels, 0 samples refused, 98760 operations"; for polygons also what
/// an edge table saves: ", 110 of 660 edges looked at", all edges on every row.
QString countsText(const OperationCounts &counts);

/// The table in lines of equal columns, with its header.
QStringList operationTableText(const OperationCounts &counts);

} // namespace pixelplumb
