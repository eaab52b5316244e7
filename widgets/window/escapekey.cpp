// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/escapekey.h"

#include <QComboBox>
#include <QKeyEvent>

namespace pixelplumb {

EscapeKey::EscapeKey(QWidget *canvas, QObject *parent)
    : QObject(parent)
    , m_canvas(canvas)
{
}

void EscapeKey::watch(QWidget *window)
{
    window->installEventFilter(this);
    // A combo box reads every key that has a text as the beginning of an entry.
    for (QComboBox *box : window->findChildren<QComboBox *>())
        box->installEventFilter(this);
}

/// A key that no widget uses reaches the window.
bool EscapeKey::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if (key.key() != Qt::Key_Escape || key.modifiers() != Qt::NoModifier)
        return QObject::eventFilter(watched, event);
    m_canvas->activateWindow();
    m_canvas->setFocus();
    return true;
}

} // namespace pixelplumb
