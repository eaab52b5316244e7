// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QtWidgets>

#include <span>

namespace pixelplumb {

/// What a person does with a scene. Each workspace has its own arrangement of the panels.
enum class Workspace {
    Step, ///< through a run, with all its numbers
    Compare, ///< methods with each other and with the truth
    Measure, ///< what accuracy costs
    Grade, ///< other people's pictures
};
constexpr Workspace allWorkspaces[]
    = {Workspace::Step, Workspace::Compare, Workspace::Measure, Workspace::Grade};

/// A panel around the canvas: a row of the table of docks. From the table come the docks, the View
/// menu's list and its keys (Alt and the row's number, 0 for the tenth; Alt, Shift and 1 for the
/// eleventh, and so on), and each workspace's first layout.
struct Panel {
    /// Its state in the first layout of its workspace.
    enum class AtFirst {
        Shown,
        Behind, ///< behind the tab of a shown one
        Hidden,
    };
    /// Whether it shows the run only up to the current step, or the finished picture as well. The
    /// latter is hidden while Predict asks what lies ahead.
    enum class Tells { SoFar, Finished };

    /// What is built when the panel is first seen.
    struct Kind {
        const QMetaObject *type;
        QWidget *(*make)(const WindowParts &parts);
    };

    const char *dock; ///< its dock's object name
    const char *title; ///< to be translated in the context of WindowDocks
    Kind kind;
    Workspace workspace;
    Qt::DockWidgetArea area; ///< in its workspace; hidden panels share a place
    AtFirst atFirst;
    Tells tells = Tells::SoFar;
};

std::span<const Panel> panels();

} // namespace pixelplumb
