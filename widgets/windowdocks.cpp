// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/windowdocks.h"

#include "widgets/columntablepanel.h"
#include "widgets/formulapanel.h"
#include "widgets/pixelgrid.h"
#include "widgets/pixelhistorypanel.h"

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
    for (QDockWidget *dock : std::as_const(m_docks))
        dock->show();
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
