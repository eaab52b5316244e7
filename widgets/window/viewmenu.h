// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

class PaletteSwitch;
class WindowDocks;
class Workspaces;

/// What is drawn over the frame, the zoom, the colours, and which panels are shown in which
/// workspace.
class ViewMenu : public QMenu {
    Q_OBJECT

public:
    ViewMenu(const WindowParts &parts, WindowDocks *docks, PaletteSwitch *palettes,
             QWidget *window);

    QAction *grid() const { return m_grid; }
    QAction *differences() const { return m_differences; }
    QAction *truth() const { return m_truth; }

    /// One action per workspace, the current one checked.
    QList<QAction *> workspaces() const { return m_workspaces; }

private:
    void addOptions(const WindowParts &parts);
    void addZoom(Canvas *canvas);
    void addWorkspaces(Workspaces *workspaces);
    void addDocks(const WindowParts &parts, WindowDocks *docks);
    void addPalettes(PaletteSwitch *palettes);

    QAction *m_grid = nullptr;
    QAction *m_differences = nullptr;
    QAction *m_truth = nullptr;
    QList<QAction *> m_workspaces;
};

} // namespace pixelplumb
