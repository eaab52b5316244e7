// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/paneldock.h"

#include <QtWidgets>

namespace pixelplumb {

class DockRoom;
class Workspaces;

/// The panels of the table, as docks around the canvas, each in its workspace.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    WindowDocks(const WindowParts &parts, QMainWindow *window);

    QList<QDockWidget *> all() const { return m_docks; }
    /// One action per dock, in their order: brings the dock to the front, or hides it if it is
    /// there already; by key, only if it has the focus as well.
    QList<QAction *> toggles() const { return m_toggles; }
    /// The dock of the panel with this class.
    template <class Widget>
    PanelDock *dockOf() const
    {
        for (QDockWidget *each : m_docks) {
            auto *dock = static_cast<PanelDock *>(each);
            if (dock->row().kind.type == &Widget::staticMetaObject)
                return dock;
        }
        Q_UNREACHABLE();
    }
    template <class Widget>
    QAction *toggleOf() const
    {
        return m_toggles[m_docks.indexOf(dockOf<Widget>())];
    }
    /// The panel, which is built now if nobody has seen it yet.
    template <class Widget>
    Widget *panel() const
    {
        return static_cast<Widget *>(dockOf<Widget>()->panel());
    }
    /// Calls `use(panel)` as soon as the panel is built: now, if it is already.
    template <class Widget, class Use>
    void whenBuilt(const Use &use)
    {
        PanelDock *dock = dockOf<Widget>();
        if (dock->isBuilt())
            return use(panel<Widget>());
        connect(dock, &PanelDock::built, this,
                [use](QWidget *built) { use(static_cast<Widget *>(built)); });
    }
    /// Shows a dock in front of those that share its place: in its panel's workspace, unless it is
    /// open in the current one.
    void raise(QDockWidget *dock);
    template <class Widget>
    Widget *raise()
    {
        raise(dockOf<Widget>());
        return panel<Widget>();
    }
    /// Whether the dock is not open although its workspace is the current one.
    bool isClosed(const PanelDock &dock) const;

    Workspaces *workspaces() const { return m_workspaces; }

signals:
    void panelBuilt(QDockWidget *dock);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void add(const Panel &panel, const WindowParts &parts);
    void addToggle(QDockWidget *dock);

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    QList<QAction *> m_toggles;
    const QObject *m_keyed = nullptr; ///< the toggle whose key was just pressed
    DockRoom *m_room = nullptr;
    Workspaces *m_workspaces = nullptr;
};

} // namespace pixelplumb
