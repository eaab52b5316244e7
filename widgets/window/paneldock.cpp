// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/paneldock.h"

#include "widgets/window/predictveil.h"
#include "widgets/window/windowdocks.h"

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

PanelDock::PanelDock(const Panel &row, const WindowParts &parts, QMainWindow *window)
    : QDockWidget(WindowDocks::tr(row.title), window)
    , m_row(row)
    , m_parts(parts)
{
    setObjectName(QLatin1String(row.dock));
    DockWidgetFeatures features = DockWidgetClosable | DockWidgetMovable;
    if (canFloat())
        features |= DockWidgetFloatable;
    setFeatures(features);
}

QWidget *PanelDock::panel()
{
    if (isBuilt())
        return widget();
    QWidget *made = m_row.kind.make(m_parts);
    setWidget(made);
    if (m_row.tells == Panel::Tells::Finished)
        new PredictVeil(m_parts.playhead, made);
    // A panel's title may depend on the method.
    connect(made, &QWidget::windowTitleChanged, this, &QDockWidget::setWindowTitle);
    if (!made->windowTitle().isEmpty())
        setWindowTitle(made->windowTitle());
    emit built(made);
    return made;
}

void PanelDock::setVisible(bool visible)
{
    if (visible)
        panel();
    QDockWidget::setVisible(visible);
}

} // namespace pixelplumb
