// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QDockWidget>
#include <QList>

class QMainWindow;

namespace pixelplumb {

class DockRoom;
struct Panel;

/// The panels of the table, as docks around the canvas, and how they lie at first.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    WindowDocks(const WindowParts &parts, QMainWindow *window);

    QList<QDockWidget *> all() const { return m_docks; }
    /// For each dock, in their order: shows it in front, and hides it where it is there already.
    QList<QAction *> toggles() const { return m_toggles; }
    /// A panel of the table, by its class.
    template <class Widget>
    Widget *panel() const
    {
        for (const QDockWidget *each : m_docks) {
            if (auto *found = qobject_cast<Widget *>(each->widget()))
                return found;
        }
        Q_UNREACHABLE();
    }
    template <class Widget>
    QDockWidget *dockOf() const
    {
        return static_cast<QDockWidget *>(panel<Widget>()->parentWidget());
    }
    /// Shows the dock of a panel, in front of those that share its place.
    void raise(QWidget *panel);

    /// As the window was at its first start.
    void reset();
    /// Shares the window's space as at the first start; after the window has its size.
    void resizeToDefault();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// How the panels share the window, by its height.
    enum class Arrangement {
        Spread, ///< all in sight: the columns and the pixel's history below everything
        Paired, ///< the pixel's two panels share a place, the columns stand below the canvas alone
        Tabbed, ///< as Paired, and the formulas share the place too
    };

    Arrangement arrangement() const;
    void arrangePixelPanels();
    void shareLeftPlace();
    void fitFormula();
    void add(const Panel &panel, const WindowParts &parts);
    void addToggle(QDockWidget *dock);
    bool isInFront(const QDockWidget &dock) const;
    bool isNarrow() const;

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    QList<QAction *> m_toggles;
    const QObject *m_keyed = nullptr; ///< the toggle whose key was just pressed
    DockRoom *m_room = nullptr;
    // Those that every arrangement places.
    QDockWidget *m_formula = nullptr;
    QDockWidget *m_pixelGrid = nullptr;
    QDockWidget *m_pixelHistory = nullptr;
    QDockWidget *m_columns = nullptr;
};

} // namespace pixelplumb
