// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/gradetable.h"

#include "widgets/studies/gradetablemodel.h"

#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int leastForComments = 120; ///< below this, comments are not worth a column
constexpr int leastForVerdicts = 400; ///< table width below which verdicts are elided

} // namespace

GradeTable::GradeTable(QAbstractItemModel *model, QWidget *parent)
    : QTableView(parent)
{
    setObjectName(QStringLiteral("gradingTable"));
    setAccessibleName(tr("Submissions"));
    setModel(model);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSortingEnabled(true);
    sortByColumn(GradeTableModel::Name, Qt::AscendingOrder);
    setWordWrap(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    horizontalHeader()->setMinimumSectionSize(24);
    horizontalHeader()->setTextElideMode(Qt::ElideRight);
}

std::optional<int> GradeTable::chosenRow() const
{
    const QModelIndexList rows = selectionModel()->selectedRows();
    return rows.isEmpty() ? std::nullopt : std::optional(rows.front().row());
}

void GradeTable::moveBy(int rows)
{
    const int count = model()->rowCount();
    if (count == 0)
        return;
    const std::optional<int> chosen = chosenRow();
    const int row = chosen ? std::clamp(*chosen + rows, 0, count - 1) : 0;
    setCurrentIndex(model()->index(row, 0));
    emit moved();
}

/// Gives the defects the width they need, before comments, which a narrow table drops: the current
/// one is shown beside it. If that is not enough, the verdict's words and long names, down to a
/// third, give way.
void GradeTable::fitColumns()
{
    QHeaderView *header = horizontalHeader();
    const auto contentWidth = [this, header](int column) {
        resizeColumnToContents(column);
        return header->sectionSize(column);
    };
    const int width = viewport()->width();
    int rest = width - contentWidth(GradeTableModel::Points) - contentWidth(GradeTableModel::State);
    const int verdicts = width < leastForVerdicts
        ? header->sectionSizeHint(GradeTableModel::Verdict)
        : contentWidth(GradeTableModel::Verdict);
    header->resizeSection(GradeTableModel::Verdict, verdicts);
    rest -= verdicts;
    const int causes = contentWidth(GradeTableModel::Cause);
    const int names = std::min(
        {contentWidth(GradeTableModel::Name),
         std::max({rest - causes, rest / 3, header->sectionSizeHint(GradeTableModel::Name)}),
         rest - header->sectionSizeHint(GradeTableModel::Cause)});
    rest -= names;
    header->resizeSection(GradeTableModel::Name, names);
    const bool hasComments = rest - causes >= leastForComments;
    setColumnHidden(GradeTableModel::Comment, !hasComments);
    header->resizeSection(GradeTableModel::Cause, hasComments ? causes : rest);
    if (hasComments)
        header->resizeSection(GradeTableModel::Comment, rest - causes);
}

void GradeTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

bool GradeTable::press(int key)
{
    switch (key) {
    case Qt::Key_J:
    case Qt::Key_Down:
        moveBy(1);
        return true;
    case Qt::Key_K:
    case Qt::Key_Up:
        moveBy(-1);
        return true;
    case Qt::Key_A:
        emit acceptAsked();
        return true;
    case Qt::Key_C:
        emit commentAsked();
        return true;
    default:
        return false;
    }
}

void GradeTable::keyPressEvent(QKeyEvent *event)
{
    const bool isPlain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (!isPlain || !press(event->key()))
        QTableView::keyPressEvent(event);
}

} // namespace pixelplumb
