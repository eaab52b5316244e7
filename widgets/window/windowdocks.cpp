// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowdocks.h"

#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/studies/motionpanel.h"
#include "widgets/studies/submissionpanel.h"
#include "widgets/window/dockroom.h"
#include "widgets/window/panels.h"
#include "widgets/window/predictveil.h"

#include <QAction>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

// Logical pixels of the window's height. Below the first there is no room for the formulas of a
// column above all that stands below the canvas; below the second they need the whole height.
constexpr int spreadHeight = 880;
constexpr int pairedHeight = 700;

/// The longest usual line of a formula with its value, logical pixels.
constexpr int formulaWidth = 440;
constexpr int leftWidth = 280; ///< of the panels left of the canvas, at least
constexpr int tabsHeight = 40; ///< more than any style's tabs; what is left over is shared out

/// Under Wayland a floating dock cannot be moved or docked again before Qt 6.6.
bool canFloat()
{
    return !QGuiApplication::platformName().startsWith(QLatin1String("wayland"))
        || QLibraryInfo::version() >= QVersionNumber(6, 6);
}

/// To what a panel names as its proxy, to itself, or to the first of its parts that Tab would
/// reach.
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
    window->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    window->setDockNestingEnabled(true);
    for (const Panel &panel : panels())
        add(panel, parts);
    m_formula = dockOf<FormulaPanel>();
    m_pixelGrid = dockOf<PixelGrid>();
    m_pixelHistory = dockOf<PixelHistoryPanel>();
    m_columns = dockOf<ColumnTablePanel>();
    connect(panel<FormulaPanel>(), &FormulaPanel::neededHeightChanged, this,
            &WindowDocks::fitFormula, Qt::QueuedConnection);
    m_room = new DockRoom(window, m_docks,
                          {m_formula, m_pixelGrid, m_pixelHistory, m_columns, formulaWidth});
    connect(panel<MotionPanel>(), &MotionPanel::neededHeightChanged, this, [this] {
        if (isInFront(*dockOf<MotionPanel>()))
            m_room->makeFor(dockOf<MotionPanel>());
    });
    for (QDockWidget *dock : std::as_const(m_docks))
        connect(dock, &QDockWidget::visibilityChanged, m_room, &DockRoom::giveBack,
                Qt::QueuedConnection);
    connect(m_formula, &QDockWidget::visibilityChanged, this, &WindowDocks::fitFormula,
            Qt::QueuedConnection);
    reset();
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
    // A panel may have another title for each method.
    connect(dock->widget(), &QWidget::windowTitleChanged, dock, &QDockWidget::setWindowTitle);
}

/// Qt's own action hides a dock whose tab is behind another's, where a person wants to see it.
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

/// Who opens a panel by its key has no hand on the mouse: what is typed next is meant for it.
bool WindowDocks::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Shortcut)
        m_keyed = watched;
    return QObject::eventFilter(watched, event);
}

/// Shown, and not behind the tab of another, where Qt places it beside the window.
bool WindowDocks::isInFront(const QDockWidget &dock) const
{
    return dock.isVisible() && !dock.visibleRegion().isEmpty();
}

void WindowDocks::raise(QWidget *panel)
{
    for (QDockWidget *dock : std::as_const(m_docks)) {
        if (dock->widget() != panel)
            continue;
        m_room->remember(dock);
        dock->show();
        dock->raise();
        // A dock that was just shown has its place only after the window's layout.
        QMetaObject::invokeMethod(
            this, [this, dock] { m_room->makeFor(dock); }, Qt::QueuedConnection);
    }
}

/// Whether the canvas would have less than half the width between panels on both of its sides.
bool WindowDocks::isNarrow() const { return m_window->width() < 2 * (formulaWidth + leftWidth); }

void WindowDocks::reset()
{
    for (QDockWidget *dock : std::as_const(m_docks)) {
        dock->setFloating(false);
        m_window->removeDockWidget(dock);
    }
    const auto placeThose = [this](Panel::AtFirst atFirst) {
        for (qsizetype i = 0; i < m_docks.size(); ++i) {
            const Panel &panel = panels()[std::size_t(i)];
            if (panel.atFirst != atFirst)
                continue;
            m_window->addDockWidget(panel.area, m_docks[i]);
            if (atFirst == Panel::AtFirst::Hidden && panel.area == Qt::BottomDockWidgetArea)
                m_window->tabifyDockWidget(m_columns, m_docks[i]);
            m_docks[i]->setVisible(atFirst == Panel::AtFirst::Shown);
        }
    };
    placeThose(Panel::AtFirst::Shown);
    arrangePixelPanels();
    placeThose(Panel::AtFirst::Hidden);
    shareLeftPlace();
    if (arrangement() == Arrangement::Paired)
        m_pixelGrid->raise();
    if (arrangement() == Arrangement::Tabbed)
        m_formula->raise();
    resizeToDefault();
}

/// The panels left of the canvas share one place; in a narrow window it is the formulas'. Above a
/// class's grades, Submission would be a third of a low window's height there.
void WindowDocks::shareLeftPlace()
{
    QDockWidget *first = nullptr;
    for (QDockWidget *dock : std::as_const(m_docks)) {
        if (m_window->dockWidgetArea(dock) != Qt::LeftDockWidgetArea)
            continue;
        const bool isLow = arrangement() != Arrangement::Spread;
        if (isNarrow() || (isLow && dock == dockOf<SubmissionPanel>()))
            m_window->tabifyDockWidget(m_formula, dock);
        else if (first)
            m_window->tabifyDockWidget(first, dock);
        else
            first = dock;
        dock->hide();
    }
}

WindowDocks::Arrangement WindowDocks::arrangement() const
{
    if (m_window->height() >= spreadHeight)
        return Arrangement::Spread;
    return m_window->height() >= pairedHeight ? Arrangement::Paired : Arrangement::Tabbed;
}

void WindowDocks::arrangePixelPanels()
{
    const Arrangement chosen = arrangement();
    const bool isSpread = chosen == Arrangement::Spread;
    m_window->setCorner(Qt::BottomRightCorner,
                        isSpread ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea);
    if (isSpread)
        m_window->splitDockWidget(m_columns, m_pixelHistory, Qt::Horizontal);
    if (chosen == Arrangement::Tabbed)
        m_window->tabifyDockWidget(m_formula, m_pixelGrid);
    if (!isSpread)
        m_window->tabifyDockWidget(m_pixelGrid, m_pixelHistory);
}

/// The formulas get the height that they need, but for what makes the pixel grid legible, its least
/// height; the other panels of their column share the rest.
void WindowDocks::fitFormula()
{
    const auto *formula = qobject_cast<const FormulaPanel *>(m_formula->widget());
    if (!isInFront(*m_formula) || m_formula->isFloating() || formula->neededHeight() == 0)
        return;
    QList<QDockWidget *> column;
    int others = 0;
    for (QDockWidget *dock : {m_pixelGrid, m_pixelHistory}) {
        // Of docks that share a place by tabs, all visible to Qt, one stands for them.
        const QList<QDockWidget *> together = m_window->tabifiedDockWidgets(dock);
        const bool isCounted = std::ranges::any_of(
            column, [&](QDockWidget *counted) { return together.contains(counted); });
        const bool isBeside = dock->isVisible() && !dock->isFloating() && !isCounted
            && m_window->dockWidgetArea(dock) == m_window->dockWidgetArea(m_formula);
        if (!isBeside)
            continue;
        column += dock;
        others += dock->height();
    }
    const int wanted = m_formula->height() - formula->height() + formula->neededHeight();
    const int rest = std::max(0, m_formula->height() + others - wanted - tabsHeight);
    QList<int> heights;
    for (const QDockWidget *dock : std::as_const(column))
        heights += std::max(1, rest * dock->height() / others);
    column.prepend(m_formula);
    heights.prepend(wanted);
    m_window->resizeDocks(column, heights, Qt::Vertical);
}

void WindowDocks::resizeToDefault()
{
    const int width = m_window->width();
    const int height = m_window->height();
    const int right = std::min(std::max(width * 37 / 100, formulaWidth), width * 45 / 100);
    m_window->resizeDocks({m_formula}, {right}, Qt::Horizontal);
    m_window->resizeDocks({m_columns}, {height * 22 / 100}, Qt::Vertical);
    if (arrangement() == Arrangement::Spread)
        m_window->resizeDocks({m_columns, m_pixelHistory}, {width - right, right}, Qt::Horizontal);
    const int formulas = m_formula->sizeHint().height();
    m_window->resizeDocks({m_formula, m_pixelGrid}, {formulas, height - formulas}, Qt::Vertical);
    fitFormula();
}

} // namespace pixelplumb
