// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

class QMainWindow;

namespace pixelplumb {

class Workspaces;

/// The settings that the window keeps from run to run in QSettings: its place, its workspaces, the
/// speed and unit of playing, the snapping and what is drawn over the frame.
class WindowSettings {
public:
    WindowSettings(const WindowParts &parts, Workspaces *workspaces, QMainWindow *window);

    void restore();
    void store() const;

private:
    void restoreChoices();

    WindowParts m_parts;
    Workspaces *m_workspaces;
    QMainWindow *m_window;
};

} // namespace pixelplumb
