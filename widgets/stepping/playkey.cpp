// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/stepping/playkey.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>

namespace pixelplumb {

namespace {

bool isSpace(const QKeyEvent &event)
{
    return event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier;
}

/// Whether the focused widget uses Space. Text fields claim the key themselves.
bool usesSpace(const QWidget *focus)
{
    if (qobject_cast<const QAbstractButton *>(focus))
        return true;
    const auto *view = qobject_cast<const QAbstractItemView *>(focus);
    return view && view->currentIndex().flags().testFlag(Qt::ItemIsUserCheckable);
}

} // namespace

void PlayKey::watch(QWidget *window) { window->installEventFilter(this); }

/// A key that no widget claims reaches the window before it becomes a shortcut.
bool PlayKey::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride || !isSpace(*static_cast<QKeyEvent *>(event))
        || !usesSpace(QApplication::focusWidget()))
        return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

} // namespace pixelplumb
