// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/wheelguard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace pixelplumb {

namespace {

/// The object as a combo or spin box, else null.
QWidget *boxOf(QObject *object)
{
    if (!qobject_cast<QComboBox *>(object) && !qobject_cast<QAbstractSpinBox *>(object))
        return nullptr;
    return static_cast<QWidget *>(object);
}

} // namespace

WheelGuard::WheelGuard(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Polish && event->type() != QEvent::Wheel)
        return QObject::eventFilter(watched, event);
    QWidget *box = boxOf(watched);
    if (box && event->type() == QEvent::Polish && box->focusPolicy() == Qt::WheelFocus)
        box->setFocusPolicy(Qt::StrongFocus); // else the wheel would give it the focus
    if (!box || event->type() != QEvent::Wheel || box->hasFocus())
        return QObject::eventFilter(watched, event);
    event->ignore(); // passed on to the parent
    return true;
}

} // namespace pixelplumb
