// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QDockWidget;
class QMainWindow;

namespace pixelplumb {

class ComparePanel;
class DisplayOptions;
class HardCasesPanel;
class Playhead;
class PerformancePanel;
class PrecisionPanel;

/// The panels around the canvas, as docks, and how they lie at first.
class WindowDocks : public QObject {
    Q_OBJECT

public:
    WindowDocks(Playhead *playhead, DisplayOptions *options, QMainWindow *window);

    QList<QDockWidget *> all() const { return m_docks; }
    QDockWidget *pixelGrid() const { return m_pixelGrid; }
    ComparePanel *compare() const { return m_compare; }
    HardCasesPanel *hardCases() const { return m_hardCases; }
    PrecisionPanel *precision() const { return m_precision; }
    /// Shows the dock of a panel, in front of those that share its place.
    void raise(QWidget *panel);

    /// As the window was at its first start.
    void reset();
    /// Shares the window's space as at the first start; after the window has its size.
    void resizeToDefault();

private:
    QDockWidget *add(const QString &name, const QString &title, QWidget *panel);
    void addStudies(Playhead *playhead);
    void makeRoomFor(QDockWidget *dock);

    QMainWindow *m_window;
    QList<QDockWidget *> m_docks;
    QDockWidget *m_formula = nullptr;
    QDockWidget *m_pixelGrid = nullptr;
    QDockWidget *m_pixelHistory = nullptr;
    QDockWidget *m_columns = nullptr;
    ComparePanel *m_compare = nullptr;
    HardCasesPanel *m_hardCases = nullptr;
    PerformancePanel *m_performance = nullptr;
    PrecisionPanel *m_precision = nullptr;
    QList<QDockWidget *> m_studies; ///< docks that are hidden at the first start
};

} // namespace pixelplumb
