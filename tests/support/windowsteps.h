// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/mainwindow.h"

namespace pixelplumb {

/// Waits for the run of the document's scene: large ones are recorded beside the GUI thread. False
/// when it does not come within two minutes.
bool waitForRun(const MainWindow &window);

/// Goes through the run in hand, to its first position, its last and others evenly between, and
/// through as many rows of the column table. Why one of them has nothing to say; empty where all
/// have.
QString faultInSteps(const MainWindow &window);

} // namespace pixelplumb
