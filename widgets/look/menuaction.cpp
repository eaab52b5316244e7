// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/menuaction.h"

#include <QWidget>

namespace pixelplumb {

void confineKeyTo(QWidget *widget, QAction *action)
{
    action->setShortcutContext(Qt::WidgetShortcut);
    widget->addAction(action);
}

} // namespace pixelplumb
