// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowdocks.h"

#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/studies/gradingpanel.h"
#include "widgets/studies/motionpanel.h"
#include "widgets/window/dockroom.h"
#include "widgets/window/firstarrangement.h"
#include "widgets/window/predictveil.h"
#include "widgets/window/workspaces.h"

#include <QAction>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// The longest usual line of a formula with its value, logical pixels.
constexpr int formulaWidth = 440;

/// Under Wayland a floating dock cannot be moved or docked again before Qt 6.6.
bool canFloat()
{
    return !QGuiApplication::platformName().startsWith(QLatin1String("wayland"))
        || QLibraryInfo::version() >= QVersionNumber(6, 6);
}

QDockWidget *dockAround(const QWidget *panel)
{
    return static_cast<QDockWidget *>(panel->parentWidget());
}

/// Gives the focus to a panel's focus proxy, to the panel itself, or to its first part that Tab
/// would reach.
void giveFocus(QWidget *panel)
{
    const auto takes = [](const QWidget *part, Qt::FocusPolicy policy) {
        return (part->focusPolicy() & policy) == policy && part->isEnabled() && part->isVisible();
    };
    if (panel->focusProxy() || panel->focusPolicy() != Qt::NoFocus) {
        panel->setFocus(Qt::ShortcutFocusReason);
        return;
    }
    for (QWidget *part = panel->nextInFocusChain(); part != panel;
         part = part->nextInFocusChain()) {
        if (!panel->isAncestorOf(part) || !takes(part, Qt::TabFocus))
            continue;
        part->setFocus(Qt::ShortcutFocusReason);
        return;
    }
}

} // namespace

WindowDocks::WindowDocks(const WindowParts &parts, QMainWindow *window)
    : QObject(window)
    , m_window(window)
{
    for (const Panel &panel : panels())
        add(panel, parts);
    const DockRoom::Usual usual
        = {dockOf<FormulaPanel>(), dockOf<PixelGrid>(), dockOf<PixelHistoryPanel>(),
           dockOf<ColumnTablePanel>(), formulaWidth};
    m_room = new DockRoom(window, m_docks, usual);
    const auto followHeightOf = [this](auto *panel, auto changed) {
        connect(panel, changed, this, [this, dock = dockAround(panel)] {
            if (isInFront(*dock))
                m_room->makeFor(dock);
        });
    };
    followHeightOf(panel<MotionPanel>(), &MotionPanel::neededHeightChanged);
    followHeightOf(panel<GradingPanel>(), &GradingPanel::neededHeightChanged);
    for (QDockWidget *dock : std::as_const(m_docks))
        connect(dock, &QDockWidget::visibilityChanged, m_room, &DockRoom::giveBack,
                Qt::QueuedConnection);
    m_workspaces
        = new Workspaces(window, new FirstArrangement(window, m_docks, usual, m_room), this);
    connect(m_workspaces, &Workspaces::leaving, panel<PredictPanel>(), &PredictPanel::leaveOpen);
}

void WindowDocks::add(const Panel &panel, const WindowParts &parts)
{
    auto *dock = new QDockWidget(tr(panel.title), m_window);
    dock->setObjectName(QLatin1String(panel.dock));
    dock->setWidget(panel.make(parts));
    if (panel.tells == Panel::Tells::Finished)
        new PredictVeil(parts.playhead, dock->widget());
    QDockWidget::DockWidgetFeatures features
        = QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable;
    if (canFloat())
        features |= QDockWidget::DockWidgetFloatable;
    dock->setFeatures(features);
    m_docks += dock;
    addToggle(dock);
    // A panel's title may depend on the method.
    connect(dock->widget(), &QWidget::windowTitleChanged, dock, &QDockWidget::setWindowTitle);
}

/// Adds an action that shows a dock or brings it to the front; Qt's own would hide a dock that is a
/// tab behind another.
void WindowDocks::addToggle(QDockWidget *dock)
{
    auto *toggle = new QAction(dock->windowTitle(), dock);
    toggle->setObjectName(dock->objectName() + QStringLiteral("Toggle"));
    toggle->setCheckable(true);
    m_toggles += toggle;
    toggle->installEventFilter(this);
    connect(toggle, &QAction::triggered, this, [this, dock, toggle] {
        const bool isByKey = std::exchange(m_keyed, nullptr) == toggle;
        if (isInFront(*dock))
            dock->close();
        else
            raise(dock->widget());
        toggle->setChecked(isInFront(*dock));
        if (isByKey && toggle->isChecked())
            giveFocus(dock->widget());
    });
    connect(dock, &QDockWidget::visibilityChanged, toggle, &QAction::setChecked);
    connect(dock, &QDockWidget::windowTitleChanged, toggle, &QAction::setText);
}

/// Notes toggles used by key: further typing is then meant for the panel.
bool WindowDocks::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Shortcut)
        m_keyed = watched;
    return QObject::eventFilter(watched, event);
}

void WindowDocks::raise(QWidget *panel)
{
    QDockWidget *dock = dockAround(panel);
    if (dock->isHidden())
        m_workspaces->goTo(workspaceOf(dock));
    m_room->remember(dock);
    dock->show();
    dock->raise();
    // A newly shown dock has its place only after the window's layout.
    QMetaObject::invokeMethod(
        this, [this, dock] { m_room->makeFor(dock); }, Qt::QueuedConnection);
}

bool WindowDocks::isClosed(QWidget *panel) const
{
    const QDockWidget *dock = dockAround(panel);
    return dock->isHidden() && workspaceOf(dock) == m_workspaces->current();
}

Workspace WindowDocks::workspaceOf(const QDockWidget *dock) const
{
    const auto row = std::ranges::find(m_docks, dock) - m_docks.begin();
    return panels()[std::size_t(row)].workspace;
}

} // namespace pixelplumb
