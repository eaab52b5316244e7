// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QtWidgets>

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

/// The forms that a primitive can take in its place: a circle or an ellipse, outlined or filled, by
/// either rule. The current form is checked; choosing another is an edit that can be undone.
class PrimitiveForms : public QMenu {
    Q_OBJECT

public:
    explicit PrimitiveForms(SceneDocument *document, QWidget *parent = nullptr);

    /// Offers the forms of this primitive; no forms without a primitive and for triangles and
    /// lines.
    void offer(std::optional<int> primitive);

private:
    void add(const QString &text, const Shape &form);

    SceneDocument *m_document;
    int m_primitive = -1;
};

} // namespace pixelplumb
