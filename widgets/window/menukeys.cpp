// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/menukeys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>

namespace pixelplumb {

namespace {

bool isPlain(const QKeyEvent &key)
{
    return (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier
        && !key.text().isEmpty();
}

/// Whether a key belongs to an open menu, which passes keys without an entry to its bar.
bool isOfOpenMenu(const QObject *watched)
{
    return qobject_cast<const QMenu *>(watched)
        || (qobject_cast<const QMenuBar *>(watched) && QApplication::activePopupWidget());
}

} // namespace

MenuKeys::MenuKeys(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// Accepting the override makes it an ordinary key, not a shortcut.
bool MenuKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride || !isOfOpenMenu(watched)
        || !isPlain(*static_cast<QKeyEvent *>(event)))
        return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

} // namespace pixelplumb
