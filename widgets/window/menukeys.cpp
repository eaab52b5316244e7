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

namespace {

bool isPlain(const QKeyEvent &key)
{
    return (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier
        && !key.text().isEmpty();
}

} // namespace

/// What is claimed before it becomes a shortcut comes to the menu as a key, and ends there: a
/// letter that no entry has does nothing.
bool MenuKeys::eventFilter(QObject *watched, QEvent *event)
{
    const bool isClaim = event->type() == QEvent::ShortcutOverride;
    if ((!isClaim && event->type() != QEvent::KeyPress) || !qobject_cast<QMenu *>(watched)
        || !isPlain(*static_cast<QKeyEvent *>(event)))
        return QObject::eventFilter(watched, event);
    if (!isClaim)
        watched->event(event);
    event->accept();
    return true;
}

} // namespace pixelplumb
