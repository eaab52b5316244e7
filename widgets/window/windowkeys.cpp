// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowkeys.h"

namespace pixelplumb {

namespace {

/// The object as a combo or spin box, else null.
QWidget *boxOf(QObject *object)
{
    if (!qobject_cast<QComboBox *>(object) && !qobject_cast<QAbstractSpinBox *>(object))
        return nullptr;
    return static_cast<QWidget *>(object);
}

/// Whether the focused widget uses Space. Text fields claim the key themselves.
bool usesSpace(const QWidget *focus)
{
    if (qobject_cast<const QAbstractButton *>(focus))
        return true;
    const auto *view = qobject_cast<const QAbstractItemView *>(focus);
    return view && view->currentIndex().flags().testFlag(Qt::ItemIsUserCheckable);
}

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

WindowKeys::WindowKeys(QWidget *canvas, QWidget *window)
    : QObject(window)
    , m_canvas(canvas)
    , m_window(window)
{
    qApp->installEventFilter(this);
}

bool WindowKeys::eventFilter(QObject *watched, QEvent *event)
{
    QWidget *box = nullptr;
    switch (event->type()) {
    case QEvent::Polish:
        box = boxOf(watched);
        if (box && box->focusPolicy() == Qt::WheelFocus)
            box->setFocusPolicy(Qt::StrongFocus); // else the wheel would give it the focus
        return false;
    case QEvent::Wheel:
        box = boxOf(watched);
        if (!box || box->hasFocus())
            return false;
        event->ignore(); // passed on to the parent
        return true;
    case QEvent::ShortcutOverride:
        if (!leavesToWidget(watched, static_cast<const QKeyEvent &>(*event)))
            return false;
        event->accept(); // an ordinary key, not a shortcut
        return true;
    case QEvent::KeyPress:
        return takesFocusBack(watched, static_cast<const QKeyEvent &>(*event));
    default:
        return false;
    }
}

/// A key that no widget uses reaches the window, or the dock that floats as one.
bool WindowKeys::isWindowOrDock(const QObject *object) const
{
    return object == m_window
        || (qobject_cast<const QDockWidget *>(object) && object->parent() == m_window);
}

bool WindowKeys::takesFocusBack(const QObject *watched, const QKeyEvent &key)
{
    if (key.key() != Qt::Key_Escape || key.modifiers() != Qt::NoModifier)
        return false;
    // A combo box reads every key that has a text as the beginning of an entry.
    const auto *combo = qobject_cast<const QComboBox *>(watched);
    if (!isWindowOrDock(watched) && !(combo && isWindowOrDock(combo->window())))
        return false;
    m_canvas->activateWindow();
    m_canvas->setFocus();
    return true;
}

bool WindowKeys::leavesToWidget(const QObject *watched, const QKeyEvent &key) const
{
    if (isOfOpenMenu(watched))
        return isPlain(key);
    return isWindowOrDock(watched) && key.key() == Qt::Key_Space
        && key.modifiers() == Qt::NoModifier && usesSpace(QApplication::focusWidget());
}

} // namespace pixelplumb
