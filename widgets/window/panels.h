// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <Qt>

#include <span>

class QWidget;

namespace pixelplumb {

/// A panel around the canvas: a row of the table of docks. Docks, the View menu's list and their
/// keys (Alt and the row's number, 0 for the tenth; Alt, Shift and 1 for the eleventh, and so on),
/// and what "reset the layout" does, come from the table.
struct Panel {
    enum class AtFirst { Shown, Hidden };
    /// Whether it shows no more of the run than the steps up to the one in hand, or the finished
    /// picture as well. The latter is hidden while Predict asks what lies ahead.
    enum class Tells { SoFar, Finished };

    const char *dock; ///< its dock's object name
    const char *title; ///< to be translated in the context of WindowDocks
    QWidget *(*make)(const WindowParts &parts);
    Qt::DockWidgetArea area; ///< at the first start; hidden ones share a place
    AtFirst atFirst;
    Tells tells = Tells::SoFar;
};

std::span<const Panel> panels();

} // namespace pixelplumb
