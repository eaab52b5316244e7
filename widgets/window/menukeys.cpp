// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/menukeys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>

namespace pixelplumb {

MenuKeys::MenuKeys(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// What is claimed before it becomes a shortcut comes to the menu as a key.
bool MenuKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride || !qobject_cast<QMenu *>(watched))
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isPlain
        = (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (!isPlain || key->text().isEmpty())
        return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

} // namespace pixelplumb
