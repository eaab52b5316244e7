// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/paneldock.h"
#include "widgets/window/panels.h"

namespace pixelplumb {

/// Lays out the panels of a workspace before a person has moved any, depending on the window's
/// size.
class FirstArrangement : public QObject {
    Q_OBJECT

public:
    /// `docks`: in the order of the table of panels.
    FirstArrangement(QMainWindow *window, const QList<QDockWidget *> &docks,
                     const DockRoom::Usual &usual, DockRoom *room);

    void lay(Workspace workspace);
    void fitFormula();

private:
    /// How the panels of Step share the window, depending on its height.
    enum class Sharing {
        Spread, ///< all visible: the columns and the pixel's history below everything
        Paired, ///< the pixel's two panels share a place, only the columns are below the canvas
        Tabbed, ///< as Paired, with the formulas in that place too
    };

    void layStep();
    void layStudies(Workspace workspace);
    void addTogether(Qt::DockWidgetArea area, const QList<QDockWidget *> &docks);
    Sharing sharing() const;
    void arrangePixelPanels();
    void shareLeftPlace();
    /// Lowers the columns below the formulas by what these lack, px.
    void shortenColumns(int lack);
    void resizeStep();
    bool isNarrow() const;

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    DockRoom::Usual m_usual;
    DockRoom *m_room;
};

} // namespace pixelplumb
