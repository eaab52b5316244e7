// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

class QWidget;

namespace pixelplumb {

class MainWindow;
class WindowDocks;

/// Connects the studies with each other and with the window: a hard case and a wrong pixel of the
/// lab open as scenes and in Compare, what the lab has to say is told.
void connectStudies(const WindowParts &parts, WindowDocks &docks, MainWindow *window);

/// Lets a person choose an example: a scene is opened, a family of hard cases shown in its dock.
void showExamples(const WindowParts &parts, WindowDocks &docks, QWidget *window);

} // namespace pixelplumb
