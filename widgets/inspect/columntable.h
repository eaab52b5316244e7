// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"
#include "widgets/model/rowfilter.h"

#include <QtWidgets>

namespace pixelplumb {

class ColumnTableDelegate;
class ColumnTableHeader;
class ColumnTableModel;
class Playhead;

/// The numbers of every column of the scan (objectName "columnTable"). The current row follows the
/// playhead's column, and the playhead the current row.
class ColumnTable : public QTableView {
    Q_OBJECT

public:
    explicit ColumnTable(Playhead *playhead, QWidget *parent = nullptr);
    ~ColumnTable() override;

    /// Checkable: which groups of columns are shown, then the exact numbers and the errors.
    const QList<QAction *> &columnActions() const { return m_columnActions; }

    /// The selected rows as tab-separated values with a header, visible columns only, numbers in
    /// canonical text.
    QString selectionAsTsv() const;

    int shownRows() const { return model()->rowCount(); }
    QSize sizeHint() const override; ///< with eight rows

public slots:
    void copySelection() const;
    void copyAll() const; ///< every shown row, in the same form
    void setFilter(pixelplumb::RowFilter filter);

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    bool event(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QString asTsv(const QList<int> &rows) const;
    void createActions();
    void takeColumns();
    void showChosenColumns();
    void fitColumns();
    QList<int> shownColumns() const;
    void followPlayhead();
    int firstRowAhead() const;
    void bringIntoView(int row);
    bool isChosen(int column) const;
    bool hasGroup(NumberGroup group) const;
    void showColumnMenu(const QPoint &position);

    Playhead *m_playhead;
    ColumnTableModel *m_model;
    ColumnTableDelegate *m_delegate;
    ColumnTableHeader *m_header;
    QList<QAction *> m_columnActions;
    QList<QAction *> m_groupActions; ///< by NumberGroup
    QAction *m_exactAction = nullptr;
    QAction *m_errorAction = nullptr;
    QAction *m_copyAction = nullptr;
    QAction *m_copyAllAction = nullptr;
    bool m_following = false; ///< the table follows the playhead, not the other way round
    bool m_isPressed = false; ///< rows must not move under the mouse
};

} // namespace pixelplumb
