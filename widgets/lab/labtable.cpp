// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labtable.h"

#include "widgets/look/numberlayout.h"

#include <QHeaderView>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>

namespace pixelplumb {

LabTable::LabTable(QWidget *parent)
    : QTableView(parent)
    , m_model(new LabTableModel(this))
    , m_sorted(new QSortFilterProxyModel(this))
{
    setObjectName(QStringLiteral("labTable"));
    setAccessibleName(tr("Contenders"));
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(LabTableModel::SortRole);
    setModel(m_sorted);
    setSortingEnabled(true);
    sortByColumn(LabTableModel::costColumn, Qt::AscendingOrder);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setFrameShape(QFrame::NoFrame);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    setFont(tabularFont(font()));
    connect(this, &QTableView::activated, this, [this](const QModelIndex &index) {
        emit contenderActivated(index.data(LabTableModel::ContenderRole).toString());
    });
}

void LabTable::show(const std::shared_ptr<const Study> &results, const QString &family)
{
    const QString kept = selected();
    {
        const QScopedValueRollback filling(m_isFilling, true);
        m_model->show(results, family);
    }
    resizeColumnsToContents();
    select(kept);
}

void LabTable::select(const QString &contender)
{
    const int row = m_model->rowOf(contender);
    const QScopedValueRollback filling(m_isFilling, true);
    if (row < 0)
        setCurrentIndex({});
    else
        setCurrentIndex(m_sorted->mapFromSource(m_model->index(row, 0)));
}

QString LabTable::selected() const
{
    return currentIndex().data(LabTableModel::ContenderRole).toString();
}

void LabTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (!m_isFilling && current.isValid() && current.row() != previous.row())
        emit contenderSelected(current.data(LabTableModel::ContenderRole).toString());
}

} // namespace pixelplumb
