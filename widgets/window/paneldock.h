// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/panels.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

/// The dock of a row of the table of panels. Its panel is built when the dock is first shown, in
/// front or behind a tab, or when somebody asks for it.
class PanelDock : public QDockWidget {
    Q_OBJECT

public:
    PanelDock(const Panel &row, const WindowParts &parts, QMainWindow *window);

    const Panel &row() const { return m_row; }
    bool isBuilt() const { return widget() != nullptr; }
    QWidget *panel();

    void setVisible(bool visible) override;

signals:
    void built(QWidget *panel);

private:
    const Panel &m_row;
    WindowParts m_parts;
};

/// Whether a dock is shown and not behind the tab of another, where Qt places it beside the window.
bool isInFront(const QDockWidget &dock);

/// Gives an opened panel its room from the canvas, and returns it when the panel closes. Half of
/// the window's width stays the canvas's, whatever is opened or dragged, and 40 % of its height,
/// unless it is low, whatever is opened, as far as the panels around it can shrink.
class DockRoom : public QObject {
    Q_OBJECT

public:
    static constexpr int tabsHeight = 40; ///< logical pixels: more than any style's tabs

    /// The panels around the canvas at first.
    struct Usual {
        QDockWidget *formula;
        QDockWidget *pixelGrid;
        QDockWidget *pixelHistory;
        QDockWidget *columns;
        int formulaWidth; ///< its needed width
    };

    DockRoom(QMainWindow *window, const QList<QDockWidget *> &docks, const Usual &usual);

    /// To be called before a panel is shown: remembers the height of the panels below the canvas.
    void remember(QDockWidget *dock);
    /// Makes room for a panel that is shown.
    void makeFor(QDockWidget *dock);

public slots:
    /// Returns to the canvas the extra height that the last study below it had.
    void giveBack();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    int half() const;
    void keepHalf();
    void makeBelow(QDockWidget *dock);
    void makeBeside(QDockWidget *dock);
    QList<QDockWidget *> studiesBelow() const;

    QMainWindow *m_window;
    QWidget *m_centre; ///< the window's central widget: the canvas and what belongs to it
    QList<QDockWidget *> m_docks;
    Usual m_usual;
    std::optional<int> m_heightBefore; ///< of the panels below the canvas, while a study has more
};

} // namespace pixelplumb
