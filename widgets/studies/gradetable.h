// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include <optional>

namespace pixelplumb {

/// The submissions of a graded folder, a row each, for an assistant's keys. One row is selected or
/// none; a table that gets the focus has a current row, but nobody chose it.
class GradeTable : public QTableView {
    Q_OBJECT

public:
    /// `model`: with GradeTableModel's columns.
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
