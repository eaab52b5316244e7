// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/stagetree.h"

#include "widgets/look/numberformat.h"
#include "widgets/look/parts.h"
#include "widgets/look/symbolitems.h"
#include "widgets/look/typesetting.h"

#include <QtWidgets>

#include <cmath>
#include <set>

namespace pixelplumb {

QString usedText(const StageNumber &number)
{
    return withMinus(displayText(Quantity::of(number.used)));
}

QString exactText(const StageNumber &number) { return withMinus(number.exact); }

QString errorText(const StageNumber &number)
{
    if (std::isnan(number.error))
        return {};
    return number.error == 0 ? u"0"_s : withMinus(QString::asprintf("%+.1e", number.error));
}

StageTree::StageTree(QWidget *parent)
    : QTreeWidget(parent)
{
    named(this, "stageTree", tr("The stages of the current face"));
    setColumnCount(ColumnCount);
    setHeaderLabels({tr("Stage"), tr("Used"), tr("Exact"), tr("Error")});
    headerItem()->setToolTip(ExactColumn,
                             tr("What the same code gives without rounding, from the "
                                "numbers of the scene"));
    headerItem()->setToolTip(ErrorColumn,
                             tr("Used − exact; at the lattice that is the snap's displacement"));
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true);
    setIndentation(indentation() / 2);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(ExactColumn, QHeaderView::Stretch);
    setItemDelegateForColumn(NameColumn, new SymbolDelegate(this));
}

void StageTree::setStages(const std::vector<ProjectionStage> &stages)
{
    std::set<QString> folded;
    for (int i = 0; i < topLevelItemCount(); ++i) {
        if (!topLevelItem(i)->isExpanded())
            folded.insert(topLevelItem(i)->text(NameColumn));
    }
    setUpdatesEnabled(false);
    clear();
    for (const ProjectionStage &stage : stages) {
        auto *item = new QTreeWidgetItem(this, {stage.title});
        fillStage(item, stage);
        item->setExpanded(!folded.contains(stage.title));
    }
    setUpdatesEnabled(true);
}

void StageTree::fillStage(QTreeWidgetItem *item, const ProjectionStage &stage)
{
    item->setFont(NameColumn, bold(font()));
    item->setFirstColumnSpanned(true);
    // One equation per row: together they are too long.
    static const QRegularExpression nextEquation(u", (?=[^,()=]+ = )"_s);
    for (const QString &equation : stage.formula.split(nextEquation))
        addSentence(item, equation);
    for (const StagePoint &point : stage.points) {
        const QString name
            = point.note.isEmpty() ? point.name : u"%1: %2"_s.arg(point.name, point.note);
        QTreeWidgetItem *row = addSentence(item, name);
        for (const StageNumber &number : point.numbers)
            addNumber(row, number);
        row->setExpanded(true);
    }
}

QTreeWidgetItem *StageTree::addSentence(QTreeWidgetItem *parent, const QString &text)
{
    auto *item = new QTreeWidgetItem(parent, {text});
    item->setFirstColumnSpanned(true);
    // The column of the numbers' names need not fit it.
    item->setSizeHint(NameColumn, QSize(1, parent->treeWidget()->fontMetrics().height() + 2));
    item->setToolTip(NameColumn, toolTipHtml({text}));
    return item;
}

void StageTree::addNumber(QTreeWidgetItem *parent, const StageNumber &number)
{
    auto *row = new QTreeWidgetItem(
        parent, {number.name, usedText(number), exactText(number), errorText(number)});
    row->setToolTip(ExactColumn, row->text(ExactColumn));
    row->setTextAlignment(ErrorColumn, Qt::AlignRight | Qt::AlignVCenter);
}

} // namespace pixelplumb
