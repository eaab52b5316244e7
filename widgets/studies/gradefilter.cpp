// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/gradefilter.h"

#include "widgets/studies/gradetablemodel.h"

#include <algorithm>

namespace pixelplumb {

GradeFilter::GradeFilter(QObject *parent)
    : QSortFilterProxyModel(parent)
{
    setSortRole(GradeTableModel::SortRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

void GradeFilter::setWords(const QString &words)
{
    m_words = words.split(u' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

void GradeFilter::setCluster(int cluster)
{
    m_cluster = cluster;
    invalidateFilter();
}

bool GradeFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const QAbstractItemModel *model = sourceModel();
    const QModelIndex first = model->index(row, 0, parent);
    if (m_cluster != allClusters && first.data(GradeTableModel::ClusterRole).toInt() != m_cluster)
        return false;
    QString text;
    for (int column = 0; column < model->columnCount(parent); ++column)
        text += first.siblingAtColumn(column).data(Qt::ToolTipRole).toString() + u'\n';
    return std::ranges::all_of(
        m_words, [&text](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace pixelplumb
