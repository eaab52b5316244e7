// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labtablemodel.h"

#include <QTableView>

class QSortFilterProxyModel;

namespace pixelplumb {

/// The contenders of a study on one family, sorted by any column (objectName "labTable").
class LabTable : public QTableView {
    Q_OBJECT

public:
    explicit LabTable(QWidget *parent = nullptr);

    void show(const std::shared_ptr<const Study> &results, const QString &family);
    void select(const QString &contender);
    QString selected() const; ///< id; empty where none is

signals:
    void contenderSelected(const QString &contender);
    void contenderActivated(const QString &contender); ///< a double click, or Enter

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    LabTableModel *m_model;
    QSortFilterProxyModel *m_sorted;
    bool m_isFilling = false;
};

} // namespace pixelplumb
