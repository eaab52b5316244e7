// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

class QMainWindow;

namespace pixelplumb {

/// What the window remembers from run to run, in QSettings: where it is, how its docks lie, the
/// speed and unit of playing, the snapping and what is drawn over the frame.
class WindowSettings {
public:
    WindowSettings(const WindowParts &parts, QMainWindow *window);

    /// False when there is no layout to restore, or one of another version of the window.
    bool restore();
    void store() const;

private:
    void restoreChoices();

    WindowParts m_parts;
    QMainWindow *m_window;
};

} // namespace pixelplumb
