// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QDockWidget>
#include <QList>

class QMainWindow;

namespace pixelplumb {

class DockRoom;
class Workspaces;
enum class Workspace;
struct Panel;

/// The panels of the table, as docks around the canvas, each in its workspace.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    WindowDocks(const WindowParts &parts, QMainWindow *window);

    QList<QDockWidget *> all() const { return m_docks; }
    /// One action per dock, in their order: brings the dock to the front, or hides it if it is
    /// there already.
    QList<QAction *> toggles() const { return m_toggles; }
    /// The panel of the table with this class.
    template <class Widget>
    Widget *panel() const
    {
        for (const QDockWidget *each : m_docks) {
            if (auto *found = qobject_cast<Widget *>(each->widget()))
                return found;
        }
        Q_UNREACHABLE();
    }
    template <class Widget>
    QDockWidget *dockOf() const
    {
        return static_cast<QDockWidget *>(panel<Widget>()->parentWidget());
    }
    /// Shows a panel's dock in front of those that share its place: in the panel's workspace,
    /// unless it is open in the current one.
    void raise(QWidget *panel);
    /// Whether the panel is not open although its workspace is the current one.
    bool isClosed(QWidget *panel) const;

    Workspaces *workspaces() const { return m_workspaces; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void add(const Panel &panel, const WindowParts &parts);
    void addToggle(QDockWidget *dock);
    Workspace workspaceOf(const QDockWidget *dock) const;

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    QList<QAction *> m_toggles;
    const QObject *m_keyed = nullptr; ///< the toggle whose key was just pressed
    DockRoom *m_room = nullptr;
    Workspaces *m_workspaces = nullptr;
};

} // namespace pixelplumb
