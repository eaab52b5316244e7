// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowdocks.h"

#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/studies/accuracy/motionpanel.h"
#include "widgets/studies/grade/gradingpanel.h"
#include "widgets/window/firstarrangement.h"
#include "widgets/window/paneldock.h"
#include "widgets/window/workspaces.h"

#include <utility>

namespace pixelplumb {

namespace {

/// The longest usual line of a formula with its value, logical pixels.
constexpr int formulaWidth = 440;

/// Gives the focus to a panel's focus proxy, to the panel itself, to its first part that Tab would
/// reach, or else to its dock.
void giveFocus(QDockWidget *dock)
{
    QWidget *panel = dock->widget();
    const auto takes = [](const QWidget *part, Qt::FocusPolicy policy) {
        return (part->focusPolicy() & policy) == policy && part->isEnabled() && part->isVisible();
    };
    if (panel->isEnabled() && (panel->focusProxy() || panel->focusPolicy() != Qt::NoFocus)) {
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
    dock->setFocus(Qt::ShortcutFocusReason);
}

bool hasFocus(const QDockWidget &dock)
{
    const QWidget *focus = QApplication::focusWidget();
    return focus && (focus == &dock || dock.isAncestorOf(focus));
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
        auto *dock = static_cast<QDockWidget *>(panel->parentWidget());
        connect(panel, changed, this, [this, dock] {
            if (isInFront(*dock))
                m_room->makeFor(dock);
        });
    };
    whenBuilt<MotionPanel>([followHeightOf](MotionPanel *panel) {
        followHeightOf(panel, &MotionPanel::neededHeightChanged);
    });
    whenBuilt<GradingPanel>([followHeightOf](GradingPanel *panel) {
        followHeightOf(panel, &GradingPanel::neededHeightChanged);
    });
    whenBuilt<AccuracyLab>([followHeightOf](AccuracyLab *panel) {
        followHeightOf(panel, &AccuracyLab::neededHeightChanged);
    });
    for (QDockWidget *dock : std::as_const(m_docks))
        connect(dock, &QDockWidget::visibilityChanged, m_room, &DockRoom::giveBack,
                Qt::QueuedConnection);
    auto *first = new FirstArrangement(window, m_docks, usual, m_room);
    whenBuilt<FormulaPanel>([first](FormulaPanel *panel) {
        connect(panel, &FormulaPanel::neededHeightChanged, first, &FirstArrangement::fitFormula,
                Qt::QueuedConnection);
    });
    m_workspaces = new Workspaces(window, first, this);
    whenBuilt<PredictPanel>([this](PredictPanel *panel) {
        connect(m_workspaces, &Workspaces::leaving, panel, &PredictPanel::leaveOpen);
    });
}

void WindowDocks::add(const Panel &panel, const WindowParts &parts)
{
    auto *dock = new PanelDock(panel, parts, m_window);
    m_docks += dock;
    addToggle(dock);
    connect(dock, &PanelDock::built, this, [this, dock] { emit panelBuilt(dock); });
}

/// Adds an action that shows a dock or brings it to the front; Qt's own would hide a dock that is a
/// tab behind another. Its key gives a dock in front the focus first, and closes it where it has it
/// already.
void WindowDocks::addToggle(QDockWidget *dock)
{
    auto *toggle = new QAction(dock->windowTitle(), dock);
    toggle->setObjectName(dock->objectName() + u"Toggle"_s);
    toggle->setCheckable(true);
    m_toggles += toggle;
    toggle->installEventFilter(this);
    connect(toggle, &QAction::triggered, this, [this, dock, toggle] {
        const bool isByKey = std::exchange(m_keyed, nullptr) == toggle;
        const bool hadFocus = hasFocus(*dock);
        if (isInFront(*dock) && (hadFocus || !isByKey)) {
            dock->close();
            if (hadFocus)
                m_window->centralWidget()->setFocus();
        } else if (!isInFront(*dock)) {
            raise(dock);
        }
        toggle->setChecked(isInFront(*dock));
        if (isByKey && toggle->isChecked())
            giveFocus(dock);
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

void WindowDocks::raise(QDockWidget *dock)
{
    if (dock->isHidden())
        m_workspaces->goTo(static_cast<PanelDock *>(dock)->row().workspace);
    m_room->remember(dock);
    dock->show();
    dock->raise();
    // A newly shown dock has its place only after the window's layout.
    QMetaObject::invokeMethod(
        this, [this, dock] { m_room->makeFor(dock); }, Qt::QueuedConnection);
}

bool WindowDocks::isClosed(const PanelDock &dock) const
{
    return dock.isHidden() && dock.row().workspace == m_workspaces->current();
}

} // namespace pixelplumb
