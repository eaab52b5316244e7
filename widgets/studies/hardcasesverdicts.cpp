// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/hardcasesverdicts.h"

#include "widgets/look/methodsummary.h"
#include "widgets/look/methodtitle.h"
#include "widgets/look/signs.h"

#include <QHeaderView>

#include <map>

namespace pixelplumb {

namespace {

constexpr int columnsInAll = int(allArithmetics.size()) + 1;

/// The verdicts of one method and arithmetic over its rules, as one cell.
struct Cell {
    int passed = 0;
    int fellShort = 0;
    QStringList remarks;

    void add(const ContenderVerdict &verdict)
    {
        passed += verdict.outcome == CaseOutcome::Passed ? 1 : 0;
        fellShort += verdict.outcome == CaseOutcome::FellShort ? 1 : 0;
        if (verdict.outcome == CaseOutcome::FellShort)
            remarks.append(verdict.contender.name() + QStringLiteral(": ")
                           + verdict.remarks.join(QStringLiteral("; ")));
    }
    QString toolTip() const
    {
        if (passed + fellShort == 0)
            return HardCasesVerdicts::tr("the case has no facts under its rules");
        return remarks.isEmpty()
            ? HardCasesVerdicts::tr("right under every rule that the case knows")
            : remarks.join(u'\n');
    }
    QString text() const
    {
        if (passed + fellShort == 0)
            return QStringLiteral("·");
        return fellShort == 0 ? QStringLiteral("✓") : QStringLiteral("✗");
    }
};

} // namespace

HardCasesVerdicts::HardCasesVerdicts(QWidget *parent)
    : QTableWidget(0, columnsInAll, parent)
{
    setObjectName(QStringLiteral("hardCaseVerdicts"));
    setAccessibleName(tr("How each method handles this case"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    verticalHeader()->hide();
    QStringList head = {tr("method")};
    for (const Arithmetic arithmetic : allArithmetics)
        head.append(QString::fromUtf8(nameOf(arithmetic)));
    setHorizontalHeaderLabels(head);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    setMinimumHeight(160);
}

void HardCasesVerdicts::show(const std::vector<ContenderVerdict> &verdicts)
{
    std::map<QString, std::map<Arithmetic, Cell>> cells;
    std::vector<const Method *> rows;
    for (const ContenderVerdict &verdict : verdicts) {
        const Method *method = verdict.contender.method;
        if (rows.empty() || rows.back() != method)
            rows.push_back(method);
        cells[method->id][verdict.contender.settings.arithmetic].add(verdict);
    }
    setRowCount(int(rows.size()));
    for (int row = 0; row < int(rows.size()); ++row) {
        const Method &method = *rows[std::size_t(row)];
        auto *title = new QTableWidgetItem(methodTitle(method));
        title->setToolTip(methodSummary(method));
        setItem(row, 0, title);
        for (int column = 1; column < columnsInAll; ++column) {
            const Arithmetic arithmetic = allArithmetics[std::size_t(column - 1)];
            const bool exists = method.supports(arithmetic);
            const Cell cell = cells[method.id][arithmetic];
            auto *item = new QTableWidgetItem(exists ? cell.text() : QString());
            item->setTextAlignment(Qt::AlignCenter);
            item->setToolTip(exists ? cell.toolTip() : tr("the method does not compute in it"));
            if (cell.fellShort > 0)
                item->setForeground(signColour(Sign::Extra, palette()));
            setItem(row, column, item);
        }
    }
}

} // namespace pixelplumb
