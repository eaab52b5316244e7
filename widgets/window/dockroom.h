// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include <optional>

class QDockWidget;
class QMainWindow;

namespace pixelplumb {

/// The room that a panel takes from the canvas while it is open, and gives back when it is closed.
class DockRoom : public QObject {
    Q_OBJECT

public:
    /// The panels that stand around the canvas at first.
    struct Usual {
        QDockWidget *formula;
        QDockWidget *pixelGrid;
        QDockWidget *pixelHistory;
        QDockWidget *columns;
        int formulaWidth; ///< that it needs
    };

    DockRoom(QMainWindow *window, const QList<QDockWidget *> &docks, const Usual &usual);

    /// Before a panel is shown: how high what stands below the canvas is.
    void remember(QDockWidget *dock);
    /// For a panel that is shown.
    void makeFor(QDockWidget *dock);

public slots:
    /// What the last study below the canvas had more is the canvas's again.
    void giveBack();

private:
    void makeBelow(QDockWidget *dock);
    void makeBeside(QDockWidget *dock);
    QList<QDockWidget *> studiesBelow() const;

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    Usual m_usual;
    std::optional<int> m_heightBefore; ///< of what is below the canvas, while a study has more
};

} // namespace pixelplumb
