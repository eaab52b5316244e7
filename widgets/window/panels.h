// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <Qt>

#include <span>

class QWidget;

namespace pixelplumb {

/// What a person does with a scene. Each has an arrangement of the panels of its own.
enum class Workspace {
    Step, ///< through a run, with all its numbers
    Compare, ///< methods with each other and with the truth
    Measure, ///< what accuracy costs
    Grade, ///< the pictures of others
};
constexpr Workspace allWorkspaces[]
    = {Workspace::Step, Workspace::Compare, Workspace::Measure, Workspace::Grade};

/// A panel around the canvas: a row of the table of docks. Docks, the View menu's list and their
/// keys (Alt and the row's number, 0 for the tenth; Alt, Shift and 1 for the eleventh, and so on),
/// and how each workspace lies at first, come from the table.
struct Panel {
    /// In its workspace, as that lies at first.
    enum class AtFirst {
        Shown,
        Behind, ///< the tab of one that is shown
        Hidden,
    };
    /// Whether it shows no more of the run than the steps up to the one in hand, or the finished
    /// picture as well. The latter is hidden while Predict asks what lies ahead.
    enum class Tells { SoFar, Finished };

    const char *dock; ///< its dock's object name
    const char *title; ///< to be translated in the context of WindowDocks
    QWidget *(*make)(const WindowParts &parts);
    Workspace workspace;
    Qt::DockWidgetArea area; ///< in its workspace; hidden ones share a place
    AtFirst atFirst;
    Tells tells = Tells::SoFar;
};

std::span<const Panel> panels();

} // namespace pixelplumb
