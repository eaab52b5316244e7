// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeView>

namespace pixelplumb {

/// The view of a PrimitiveListModel. F2 or Enter edits a vertex, x first; Tab goes on to y, then to
/// the next vertex. A double click on a colour, or Enter on a primitive, asks for another colour.
class PrimitivesTree : public QTreeView {
    Q_OBJECT

public:
    explicit PrimitivesTree(QWidget *parent = nullptr);

signals:
    /// For the current row.
    void colourAsked();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    /// Visits the numbers of a row before the next row.
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;

private:
    bool editCurrent();
};

} // namespace pixelplumb
