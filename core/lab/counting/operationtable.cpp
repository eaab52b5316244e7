// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/operationtable.h"

#include <cmath>

namespace pixelplumb {

namespace {

QString countOf(std::int64_t count, const QString &one, const QString &many)
{
    return u"%1 %2"_s.arg(count).arg(count == 1 ? one : many);
}

QString tableLine(const QString &name, const QStringList &cells)
{
    QString line = name.leftJustified(19);
    for (const QString &cell : cells)
        line += cell.rightJustified(12);
    return line;
}

} // namespace

std::vector<OperationTableRow> operationTable(const OperationCounts &counts)
{
    const OperationRow totals = counts.totals();
    std::vector<OperationTableRow> rows;
    OperationTableRow sum;
    sum.name = QT_TRANSLATE_NOOP("core", "all");
    for (const Operation operation : allOperations) {
        OperationTableRow row;
        row.name = QString::fromLatin1(nameOf(operation).data());
        row.all = totals[std::size_t(operation)];
        for (const WorkStage stage : allWorkStages) {
            row.each[std::size_t(stage)] = counts.perTime(stage, operation);
            sum.each[std::size_t(stage)] += row.each[std::size_t(stage)];
        }
        sum.all += row.all;
        if (row.all != 0)
            rows.push_back(row);
    }
    rows.push_back(sum);
    return rows;
}

QString operationText(double each)
{
    return QString::number(each, 'f', each == std::floor(each) ? 0 : 2);
}

QString countsText(const OperationCounts &counts)
{
    QStringList texts
        = {countOf(counts.primitives, "set-up", "set-ups"), countOf(counts.spans, "span", "spans"),
           countOf(counts.pixels, "pixel", "pixels"),
           countOf(counts.refused, "sample refused", "samples refused"),
           countOf(counts.total(), "operation", "operations")};
    if (counts.edgesOfRows > 0)
        texts.append(QStringLiteral(QT_TRANSLATE_NOOP("core", "%1 of %2 edges looked at"))
                         .arg(counts.edgesLookedAt)
                         .arg(counts.edgesOfRows));
    return texts.join(u", "_s);
}

QStringList operationTableText(const OperationCounts &counts)
{
    QStringList lines = {tableLine({}, {"a set-up", "a span", "a sample", "all"})};
    for (const OperationTableRow &row : operationTable(counts)) {
        QStringList cells;
        for (const double each : row.each)
            cells.append(operationText(each));
        lines.append(tableLine(row.name, cells + QStringList{QString::number(row.all)}));
    }
    return lines;
}

} // namespace pixelplumb
