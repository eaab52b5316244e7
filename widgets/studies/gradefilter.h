// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>

namespace pixelplumb {

/// Filters the submissions of a cluster by words: each word must occur somewhere in the row.
class GradeFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    static constexpr int allClusters = -1;

    explicit GradeFilter(QObject *parent = nullptr);

    void setWords(const QString &words);
    void setCluster(int cluster);

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    QStringList m_words;
    int m_cluster = allClusters;
};

} // namespace pixelplumb
