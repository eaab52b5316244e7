// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QDockWidget;
class QMainWindow;

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// The panels around the canvas, as docks, and how they lie at first.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    WindowDocks(Playhead *playhead, DisplayOptions *options, QMainWindow *window);

    QList<QDockWidget *> all() const { return m_docks; }
    QDockWidget *pixelGrid() const { return m_pixelGrid; }

    /// As the window was at its first start.
    void reset();
    /// Shares the window's space as at the first start; after the window has its size.
    void resizeToDefault();

private:
    QDockWidget *add(const QString &name, const QString &title, QWidget *panel);

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    QDockWidget *m_formula = nullptr;
    QDockWidget *m_pixelGrid = nullptr;
    QDockWidget *m_pixelHistory = nullptr;
    QDockWidget *m_columns = nullptr;
};

} // namespace pixelplumb
