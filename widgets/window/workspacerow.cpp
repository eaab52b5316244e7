// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/workspacerow.h"

#include <QAction>
#include <QBoxLayout>
#include <QToolButton>

namespace pixelplumb {

WorkspaceRow::WorkspaceRow(const QList<QAction *> &workspaces, QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("workspaceRow"));
    setAccessibleName(tr("Workspaces"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(0);
    for (QAction *action : workspaces) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setAccessibleName(action->iconText());
        button->setAutoRaise(true);
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
        layout->addWidget(button);
    }
}

QSize WorkspaceRow::minimumSizeHint() const
{
    return {layout()->minimumSize().width(), fontMetrics().height() + 4};
}

} // namespace pixelplumb
