// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/mainwindow.h"

namespace pixelplumb {

/// Waits for the run of the document's scene: large ones are traced in the background. False if it
/// does not arrive within two minutes.
bool waitForRun(const MainWindow &window);

/// Steps through the current run (its first position, its last and others evenly between) and
/// through equally many rows of the column table. Returns why one of them shows nothing; empty if
/// all show something.
QString faultInSteps(const MainWindow &window);

} // namespace pixelplumb
