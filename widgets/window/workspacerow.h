// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QAction;

namespace pixelplumb {

/// A row of buttons for the window's upper right corner, one per workspace, the current one
/// pressed.
class WorkspaceRow : public QWidget {
    Q_OBJECT

public:
    /// `workspaces`: checkable actions, one of which is checked.
    explicit WorkspaceRow(const QList<QAction *> &workspaces, QWidget *parent = nullptr);

    /// No higher than the menu titles next to it.
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }
};

} // namespace pixelplumb
