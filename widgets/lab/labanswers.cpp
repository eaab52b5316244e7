// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labanswers.h"

#include "widgets/lab/labtext.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberlayout.h"

#include <QHeaderView>

namespace pixelplumb {

namespace {

enum AnswerColumn { BudgetColumn, ContenderColumn, GroundColumn, TimeColumn, ReasonColumn };

constexpr int leastReason = 320; ///< width of its column, logical pixels

QString groundText(const BudgetAnswer &answer)
{
    switch (answer.ground) {
    case BudgetGround::Proof:
        return kernelOf(answer.contender) == LabKernel::Plain ? LabAnswers::tr("proof")
                                                              : LabAnswers::tr("proof and test");
    case BudgetGround::Measurement:
        return LabAnswers::tr("measurement");
    case BudgetGround::Nobody:
        break;
    }
    return LabAnswers::tr("nobody");
}

} // namespace

LabAnswers::LabAnswers(QWidget *parent)
    : QTableWidget(0, ReasonColumn + 1, parent)
{
    setObjectName(QStringLiteral("labAnswers"));
    setAccessibleName(tr("The cheapest contender for each budget"));
    setHorizontalHeaderLabels(
        {tr("budget"), tr("cheapest contender"), tr("known by"), tr("ns a pixel"), tr("reason")});
    for (int column = 0; column <= ReasonColumn; ++column)
        horizontalHeaderItem(column)->setTextAlignment(
            (column == TimeColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    horizontalHeaderItem(BudgetColumn)->setToolTip(tr("What is asked for"));
    horizontalHeaderItem(ContenderColumn)
        ->setToolTip(tr("Who gives it for the least time on this family of triangles"));
    horizontalHeaderItem(GroundColumn)
        ->setToolTip(tr("Whether it is proved, or was only never seen otherwise in this study. A "
                        "SIMD kernel is tested to write what the proved plain one does"));
    horizontalHeaderItem(TimeColumn)->setToolTip(tr("The median of all rounds"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setFrameShape(QFrame::NoFrame);
    setTabKeyNavigation(false);
    setWordWrap(true);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(ReasonColumn, QHeaderView::Stretch);
    setFont(tabularFont(font()));
    connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
        if (currentRow() >= 0)
            emit contenderSelected(item(currentRow(), BudgetColumn)->data(Qt::UserRole).toString());
    });
}

/// The reasons take the remaining width; if that is too little, the table scrolls.
void LabAnswers::resizeEvent(QResizeEvent *event)
{
    QTableWidget::resizeEvent(event);
    int others = 0;
    for (int column = 0; column < ReasonColumn; ++column)
        others += columnWidth(column);
    const bool isRoom = viewport()->width() - others >= leastReason;
    horizontalHeader()->setSectionResizeMode(ReasonColumn,
                                             isRoom ? QHeaderView::Stretch : QHeaderView::Fixed);
    if (!isRoom)
        setColumnWidth(ReasonColumn, leastReason);
}

void LabAnswers::show(const Study &study, const QString &family)
{
    const QSignalBlocker blocker(this);
    setRowCount(int(allBudgets.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const BudgetAnswer answer = cheapestFor(allBudgets[std::size_t(row)], study, family);
        const StudyContender *contender = study.contender(answer.contender);
        const auto put = [this, row](int column, const QString &text) {
            auto *cell = new QTableWidgetItem(text);
            cell->setTextAlignment((column == TimeColumn ? Qt::AlignRight : Qt::AlignLeft)
                                   | Qt::AlignVCenter);
            cell->setToolTip(text);
            setItem(row, column, cell);
        };
        put(BudgetColumn, coreWord(textOf(answer.budget)));
        put(ContenderColumn, contender ? contender->label : answer.contender);
        put(GroundColumn, groundText(answer));
        put(TimeColumn,
            answer.nanosecondsPerPixel > 0 ? figureText(answer.nanosecondsPerPixel) : QString());
        put(ReasonColumn, answer.reason);
        item(row, BudgetColumn)->setData(Qt::UserRole, answer.contender);
    }
}

} // namespace pixelplumb
