// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include <optional>

namespace pixelplumb {

/// The submissions of a graded folder, a row each, for the keys of an assistant. One row is
/// selected or none; a table that takes the focus has a current row, but nobody chose it.
class GradeTable : public QTableView {
    Q_OBJECT

public:
    /// Of a model with GradeTableModel's columns.
    explicit GradeTable(QAbstractItemModel *model, QWidget *parent = nullptr);

    std::optional<int> chosenRow() const;
    /// Chooses the row so many below the chosen one, at most the last; where none is, the first.
    void moveBy(int rows);
    /// What is longer than its column is in its tool tip.
    void fitColumns();

signals:
    void moved(); ///< by a key, if only to where it was
    void acceptAsked();
    void commentAsked();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    bool press(int key);
};

} // namespace pixelplumb
