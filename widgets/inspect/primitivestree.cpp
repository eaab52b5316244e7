// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/primitivestree.h"

#include "widgets/model/primitivelistmodel.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace pixelplumb {

PrimitivesTree::PrimitivesTree(QWidget *parent)
    : QTreeView(parent)
{
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                    | QAbstractItemView::AnyKeyPressed);
}

/// False where the current row has no numbers to edit.
bool PrimitivesTree::editCurrent()
{
    const QModelIndex x = currentIndex().siblingAtColumn(PrimitiveListModel::X);
    if (!x.flags().testFlag(Qt::ItemIsEditable))
        return false;
    if (!currentIndex().flags().testFlag(Qt::ItemIsEditable))
        setCurrentIndex(x);
    edit(currentIndex());
    return true;
}

void PrimitivesTree::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if ((isEnter || event->key() == Qt::Key_F2) && state() != EditingState && editCurrent())
        return;
    if (isEnter && state() != EditingState && currentIndex().isValid())
        emit colourAsked();
    else
        QTreeView::keyPressEvent(event);
}

void PrimitivesTree::mouseDoubleClickEvent(QMouseEvent *event)
{
    const QModelIndex index = indexAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && index.column() == PrimitiveListModel::ColourText)
        emit colourAsked(); // the first click has made the row current
    else
        QTreeView::mouseDoubleClickEvent(event);
}

QModelIndex PrimitivesTree::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers)
{
    using Model = PrimitiveListModel;
    const QModelIndex index = currentIndex();
    const bool isBetween = (action == MoveNext && index.column() == Model::X)
        || (action == MovePrevious && index.column() == Model::Y);
    if (isBetween)
        return index.siblingAtColumn(action == MoveNext ? Model::Y : Model::X);
    const QModelIndex next = QTreeView::moveCursor(action, modifiers);
    if (action == MoveNext && index.column() == Model::Y)
        return next.siblingAtColumn(Model::X);
    if (action == MovePrevious && index.column() == Model::X)
        return next.siblingAtColumn(Model::Y);
    return next;
}

} // namespace pixelplumb
