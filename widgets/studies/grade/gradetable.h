// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/rowsmodel.h"

#include <QSortFilterProxyModel>

#include <optional>

namespace pixelplumb {

class Gradebook;

/// The columns of gradeRows(). State shows only a tick, so that the table fits beside the comment;
/// its tool tip and accessible text have the word.
struct GradeColumn {
    enum { Name, Points, Verdict, Cause, State, Comment };
};

/// A row per submission, by its index in the report.
using GradeRows = RowsModel<std::size_t>;
GradeRows *gradeRows(const Gradebook *book, QObject *parent);

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

/// The submissions of a graded folder, a row each, for an assistant's keys. One row is selected or
/// none; a table that gets the focus has a current row, but nobody chose it.
class GradeTable : public QTableView {
    Q_OBJECT

public:
    /// `model`: with the columns of gradeRows().
    explicit GradeTable(QAbstractItemModel *model, QWidget *parent = nullptr);

    std::optional<int> chosenRow() const;
    /// Selects the row `rows` below the selected one, at most the last; the first where none is
    /// selected.
    void moveBy(int rows);
    /// Text longer than its column is in the tool tip.
    void fitColumns();

signals:
    void moved(); ///< by a key, even to the same row
    void acceptAsked();
    void commentAsked();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    bool press(int key);
};

} // namespace pixelplumb
