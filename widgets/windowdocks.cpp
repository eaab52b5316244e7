// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/windowdocks.h"

#include "widgets/columntablepanel.h"
#include "widgets/comparepanel.h"
#include "widgets/formulapanel.h"
#include "widgets/hardcasespanel.h"
#include "widgets/performancepanel.h"
#include "widgets/pixelgrid.h"
#include "widgets/pixelhistorypanel.h"
#include "widgets/precisionpanel.h"

#include <QAction>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QMainWindow>

namespace pixelplumb {

namespace {

/// Under Wayland a floating dock cannot be moved or docked again before Qt 6.6.
bool canFloat()
{
    return !QGuiApplication::platformName().startsWith(QLatin1String("wayland"))
        || QLibraryInfo::version() >= QVersionNumber(6, 6);
}

} // namespace

WindowDocks::WindowDocks(Playhead *playhead, DisplayOptions *options, QMainWindow *window)
    : QObject(window)
    , m_window(window)
{
    // The columns' numbers need the whole width.
    window->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    window->setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    window->setDockNestingEnabled(true);
    m_formula = add(QStringLiteral("formulaDock"), tr("Formula"), new FormulaPanel(playhead));
    m_pixelGrid
        = add(QStringLiteral("pixelGridDock"), tr("Pixel grid"), new PixelGrid(playhead, options));
    m_pixelHistory
        = add(QStringLiteral("pixelHistoryDock"), tr("Pixel"), new PixelHistoryPanel(playhead));
    m_columns = add(QStringLiteral("columnsDock"), tr("Columns"), new ColumnTablePanel(playhead));
    addStudies(playhead);
    reset();
}

QDockWidget *WindowDocks::add(const QString &name, const QString &title, QWidget *panel)
{
    auto *dock = new QDockWidget(title, m_window);
    dock->setObjectName(name);
    dock->setWidget(panel);
    QDockWidget::DockWidgetFeatures features
        = QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable;
    if (canFloat())
        features |= QDockWidget::DockWidgetFloatable;
    dock->setFeatures(features);
    m_docks += dock;
    return dock;
}

void WindowDocks::addStudies(Playhead *playhead)
{
    m_compare = new ComparePanel(playhead);
    m_hardCases = new HardCasesPanel(playhead);
    m_precision = new PrecisionPanel(playhead);
    m_performance = new PerformancePanel(playhead);
    m_studies = {add(QStringLiteral("compareDock"), tr("Compare"), m_compare),
                 add(QStringLiteral("precisionDock"), tr("Precision"), m_precision),
                 add(QStringLiteral("hardCasesDock"), tr("Hard cases"), m_hardCases),
                 add(QStringLiteral("performanceDock"), tr("Performance"), m_performance)};
    for (QDockWidget *dock : std::as_const(m_studies)) {
        connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
            if (shown)
                raise(dock->widget());
        });
    }
}

void WindowDocks::raise(QWidget *panel)
{
    for (QDockWidget *dock : std::as_const(m_docks)) {
        if (dock->widget() != panel)
            continue;
        dock->show();
        dock->raise();
        // A dock that was just shown has its place only after the window's layout.
        QMetaObject::invokeMethod(
            this, [this, dock] { makeRoomFor(dock); }, Qt::QueuedConnection);
    }
}

/// A study needs more than the strip that the columns have at first; the canvas keeps the rest.
void WindowDocks::makeRoomFor(QDockWidget *dock)
{
    const int wanted = m_window->height() * 50 / 100;
    if (!dock->isFloating() && m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea
        && dock->height() < wanted)
        m_window->resizeDocks({dock}, {wanted}, Qt::Vertical);
}

void WindowDocks::reset()
{
    for (QDockWidget *dock : std::as_const(m_docks)) {
        dock->setFloating(false);
        m_window->removeDockWidget(dock);
    }
    m_window->addDockWidget(Qt::RightDockWidgetArea, m_formula);
    m_window->addDockWidget(Qt::RightDockWidgetArea, m_pixelGrid);
    m_window->addDockWidget(Qt::RightDockWidgetArea, m_pixelHistory);
    m_window->addDockWidget(Qt::BottomDockWidgetArea, m_columns);
    for (QDockWidget *dock : std::as_const(m_studies)) {
        const bool isTall = dock->widget() == m_hardCases || dock->widget() == m_performance;
        m_window->addDockWidget(isTall ? Qt::LeftDockWidgetArea : Qt::BottomDockWidgetArea, dock);
        if (!isTall)
            m_window->tabifyDockWidget(m_columns, dock);
    }
    for (QDockWidget *dock : std::as_const(m_docks))
        dock->setVisible(!m_studies.contains(dock));
    resizeToDefault();
}

void WindowDocks::resizeToDefault()
{
    const int width = m_window->width();
    const int height = m_window->height();
    m_window->resizeDocks({m_formula}, {width * 37 / 100}, Qt::Horizontal);
    m_window->resizeDocks({m_columns}, {height * 20 / 100}, Qt::Vertical);
    m_window->resizeDocks({m_formula, m_pixelGrid, m_pixelHistory}, {36, 40, 24}, Qt::Vertical);
}

} // namespace pixelplumb
