// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

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

/// Calls `update` now, and whenever the sender emits the signal.
template <class Sender, class Signal, class Update>
void keepUpdated(const Sender *sender, Signal signal, QObject *context, Update update)
{
    QObject::connect(sender, signal, context, update);
    update();
}

/// Appends a checkable action, which is checked where `isChecked()` says so at the signal.
template <class Trigger, class Sender, class Signal, class IsChecked>
QAction *addSwitch(QMenu *menu, const char *name, const QString &text, const QKeySequence &key,
                   Trigger trigger, const Sender *sender, Signal signal, IsChecked isChecked)
{
    QAction *action = addMenuAction(menu, name, text, key, trigger);
    action->setCheckable(true);
    keepUpdated(sender, signal, action, [action, isChecked] { action->setChecked(isChecked()); });
    return action;
}

/// The menu's actions and those of its submenus, without separators.
QList<QAction *> actionsIn(const QMenu &menu);

/// A menu text as it is read: "Open" for "&Open…".
QString withoutMnemonic(QString text);

/// The name of an action in lists of keys: as withoutMnemonic(), except that an action whose menu
/// text says what it would do now, such as "Undo place vertex", has the name last set with
/// setListedText().
QString listedText(const QAction &action);
void setListedText(QAction *action, const QString &text);

/// The tip with its key, "Play (Space)"; the tip alone without a key.
QString tipWithKey(const QString &tip, const QKeySequence &key);

/// Lets the action's key act only while the widget has the focus: for letters and digits, which
/// elsewhere are typed as text.
void confineKeyTo(QWidget *widget, QAction *action);

} // namespace pixelplumb
