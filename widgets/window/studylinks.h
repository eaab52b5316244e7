// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

class QWidget;

namespace pixelplumb {

class MainWindow;
class WindowDocks;

/// Connects the studies with each other and with the window: hard cases and wrong pixels of the lab
/// open as scenes and in Compare, and the lab's messages are shown.
void connectStudies(const WindowParts &parts, WindowDocks &docks, MainWindow *window);

/// Lets a person choose an example: a scene is opened, a family of hard cases is shown in its dock.
void showExamples(const WindowParts &parts, WindowDocks &docks, QWidget *window);

} // namespace pixelplumb
