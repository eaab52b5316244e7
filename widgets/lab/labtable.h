// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <QAbstractTableModel>
#include <QTableView>

#include <memory>

class QSortFilterProxyModel;

namespace pixelplumb {

/// The contenders of a study on one family, a row each. The columns are a table in the source file;
/// what was not measured is empty and sorts last.
class LabTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// A number to sort by; the text in text columns.
    static constexpr int SortRole = Qt::UserRole;
    static constexpr int costColumn = 2; ///< ns a pixel
    static constexpr int ContenderRole = Qt::UserRole + 1; ///< id

    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::shared_ptr<const Study> &results, const QString &family);
    /// −1 where the contender is not in the table.
    int rowOf(const QString &contender) const;
    const LabRow &rowAt(int row) const { return *m_rows[std::size_t(row)]; }

    int rowCount(const QModelIndex &parent = {}) const final;
    int columnCount(const QModelIndex &parent = {}) const final;
    QVariant data(const QModelIndex &index, int role) const final;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const final;

private:
    std::shared_ptr<const Study> m_results;
    std::vector<const LabRow *> m_rows; ///< of the family
};

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
