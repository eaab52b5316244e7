// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/panels.h"

#include <QtWidgets>

#include <array>
#include <iterator>

namespace pixelplumb {

class FirstArrangement;

/// The window's current workspace, the way back to earlier ones, and the layout of each one's
/// panels: as a person last left them, in this run or before, else the first layout.
class Workspaces : public QObject {
    Q_OBJECT

public:
    Workspaces(QMainWindow *window, FirstArrangement *first, QObject *parent);

    Workspace current() const { return m_current; }
    void goTo(Workspace workspace);
    bool canGoBack() const { return !m_visited.isEmpty(); }
    /// Returns to the previous workspace, like a browser to a page.
    void goBack();
    /// Restores the first layout of the current workspace; the others stay as they are.
    void reset();

    /// Restores the layouts of the previous run; the first layout where it left none that this
    /// window can show.
    void restore(const QSettings &settings);
    void store(QSettings &settings);

signals:
    void leaving(); ///< the current workspace, with its panels still there
    void changed();

private:
    /// What is restored in a workspace.
    struct Kept {
        QByteArray layout;
        QPointer<QWidget> focus;
    };

    Kept &kept(Workspace workspace) { return m_kept[std::size_t(workspace)]; }
    void keepCurrent();
    void showCurrent();
    void enter(Workspace workspace);

    QMainWindow *m_window;
    FirstArrangement *m_first;
    Workspace m_current = Workspace::Step;
    QList<Workspace> m_visited; ///< those before the current one
    std::array<Kept, std::size(allWorkspaces)> m_kept;
};

/// The workspace's title for a button: "Step".
QString titleOf(Workspace workspace);

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
