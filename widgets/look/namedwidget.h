// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace pixelplumb {

/// Names a widget: its object name, and in words its accessible name and tool tip.
template <class Widget>
Widget *named(Widget *widget, const char *name, const QString &inWords)
{
    widget->setObjectName(QLatin1String(name));
    widget->setAccessibleName(inWords);
    widget->setToolTip(inWords);
    return widget;
}

inline QToolButton *namedButton(const char *name, const QString &text, const QString &inWords,
                                QWidget *parent)
{
    auto *button = named(new QToolButton(parent), name, inWords);
    button->setText(text);
    return button;
}

} // namespace pixelplumb
