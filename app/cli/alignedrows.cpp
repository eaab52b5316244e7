// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/alignedrows.h"

#include <algorithm>

namespace pixelplumb::cli {

QStringList alignedRows(const std::vector<QStringList> &rows,
                        const std::function<bool(qsizetype column)> &holdsWords)
{
    QList<qsizetype> widths(rows.front().size(), 0);
    for (const QStringList &row : rows) {
        for (qsizetype column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    QStringList lines;
    for (const QStringList &row : rows) {
        QStringList cells;
        for (qsizetype column = 0; column < row.size(); ++column)
            cells.append(holdsWords(column) ? row[column].leftJustified(widths[column])
                                            : row[column].rightJustified(widths[column]));
        QString line = cells.join(QStringLiteral("  "));
        while (line.endsWith(u' '))
            line.chop(1);
        lines.append(line);
    }
    return lines;
}

} // namespace pixelplumb::cli
