// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QList>

class QAction;
class QLabel;
class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace pixelplumb {

class KeyField;

/// Other keys for the actions of the menus (objectName "keysDialog"): a row an action, and a field
/// that takes the key pressed in it for the row in hand. A key that another action has is not
/// taken, and who has it is said. What is chosen counts at once and is kept for the next session
/// (see restoreKeys).
class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(const QList<QMenu *> &menus, QWidget *parent = nullptr);

private:
    void fill(const QList<QMenu *> &menus);
    void showRow(QTreeWidgetItem *row);
    void showOnly(const QString &words);
    void takeKey();
    /// To the action in hand, unless another has one of them.
    void offerKeys(const QList<QKeySequence> &keys);
    void giveKeys(QAction *action, const QList<QKeySequence> &keys);
    QAction *actionInHand() const;

    QList<QAction *> m_actions;
    QTreeWidget *m_rows;
    KeyField *m_key;
    QLabel *m_message;
};

/// Gives the actions of the menus the keys that were chosen in former sessions. To be called once,
/// before any dialog: the keys that the actions have then are their defaults.
void restoreKeys(const QList<QMenu *> &menus);

} // namespace pixelplumb
