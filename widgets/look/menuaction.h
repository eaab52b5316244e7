// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>

namespace pixelplumb {

/// Appends a named action to a menu and calls `trigger` in the context of the menu.
template <class Trigger>
QAction *addMenuAction(QMenu *menu, const char *name, const QString &text, const QKeySequence &key,
                       Trigger trigger)
{
    QAction *action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(key);
    QObject::connect(action, &QAction::triggered, menu, trigger);
    return action;
}

/// The menu's actions and those of the menus in it, without separators.
QList<QAction *> actionsIn(const QMenu &menu);

/// "&Open…" as it is read: "Open".
QString withoutMnemonic(QString text);

/// What lists of keys call an action: as withoutMnemonic(), but for one whose text in its menu says
/// what it would do now, such as "Undo place vertex". That one is called as it was last set here.
QString listedText(const QAction &action);
void setListedText(QAction *action, const QString &text);

/// "Play (Space)"; without a key the tip alone.
QString tipWithKey(const QString &tip, const QKeySequence &key);

/// Lets the action's key act only while the widget has the focus: for keys that are letters or
/// digits, which belong to whatever is typed elsewhere.
void confineKeyTo(QWidget *widget, QAction *action);

} // namespace pixelplumb
