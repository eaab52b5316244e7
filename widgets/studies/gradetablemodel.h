// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace pixelplumb {

class Gradebook;

/// A row per submission, in the report's order.
class GradeTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// State shows only a tick, so that the table fits beside the comment; its tool tip and
    /// accessible text have the word.
    enum Column { Name, Points, Verdict, Cause, State, Comment, ColumnCount };
    enum Role {
        SortRole = Qt::UserRole, ///< numbers by value
        ClusterRole, ///< index of its cluster
    };

    explicit GradeTableModel(const Gradebook *book, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    QString textOf(std::size_t row, int column) const;

    const Gradebook *m_book;
};

} // namespace pixelplumb
