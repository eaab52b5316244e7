// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

/// The menu of moves in time, with their keys.
class StepMenu : public QMenu {
    Q_OBJECT

public:
    StepMenu(const WindowParts &parts, QWidget *window);
};

} // namespace pixelplumb
