// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/firstarrangement.h"

#include "widgets/inspect/formulapanel.h"

#include <QtWidgets>

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

// Logical pixels of the window's height. Below the first, a column's formulas do not fit above the
// panels below the canvas; below the second, they need the whole height.
constexpr int spreadHeight = 880;
constexpr int pairedHeight = 700;

constexpr int leftWidth = 280; ///< of the panels left of the canvas, at least
constexpr int lineWidth = 500; ///< of the formulas: a line of an edge in exact numbers

constexpr int leastRows = 3; ///< of the columns, where the formulas need the height

// Percent of the window's height, of the columns at first.
constexpr int leastColumns = 20;
constexpr int mostColumns = 36;

} // namespace

FirstArrangement::FirstArrangement(QMainWindow *window, const QList<QDockWidget *> &docks,
                                   const DockRoom::Usual &usual, DockRoom *room)
    : QObject(room)
    , m_window(window)
    , m_docks(docks)
    , m_usual(usual)
    , m_room(room)
{
    window->setDockNestingEnabled(true);
    connect(usual.formula, &QDockWidget::visibilityChanged, this, &FirstArrangement::fitFormula,
            Qt::QueuedConnection);
}

void FirstArrangement::lay(Workspace workspace)
{
    for (QDockWidget *dock : std::as_const(m_docks)) {
        if (dock->isFloating())
            dock->setFloating(false);
        m_window->removeDockWidget(dock);
    }
    if (workspace == Workspace::Step)
        layStep();
    else
        layStudies(workspace);
}

void FirstArrangement::layStep()
{
    m_window->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    const auto isShown = [](const Panel &panel) {
        return panel.workspace == Workspace::Step && panel.atFirst == Panel::AtFirst::Shown;
    };
    for (qsizetype i = 0; i < m_docks.size(); ++i) {
        const Panel &panel = panels()[std::size_t(i)];
        if (!isShown(panel))
            continue;
        m_window->addDockWidget(panel.area, m_docks[i]);
        m_docks[i]->show();
    }
    arrangePixelPanels();
    for (qsizetype i = 0; i < m_docks.size(); ++i) {
        const Panel &panel = panels()[std::size_t(i)];
        if (isShown(panel))
            continue;
        m_window->addDockWidget(panel.area, m_docks[i]);
        if (panel.area == Qt::BottomDockWidgetArea)
            m_window->tabifyDockWidget(m_usual.columns, m_docks[i]);
        if (panel.area == Qt::RightDockWidgetArea)
            m_window->tabifyDockWidget(m_usual.formula, m_docks[i]);
        m_docks[i]->hide();
    }
    shareLeftPlace();
    if (sharing() == Sharing::Paired)
        m_usual.pixelGrid->raise();
    if (sharing() == Sharing::Tabbed)
        m_usual.formula->raise();
    resizeStep();
}

/// Puts the studies that belong below the canvas, or to its right, each behind the other, and the
/// hidden ones of other workspaces with those below; panels beside the canvas get the full height.
void FirstArrangement::layStudies(Workspace workspace)
{
    m_window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QList<QDockWidget *> right;
    QList<QDockWidget *> below;
    QList<QDockWidget *> foreign;
    QList<QDockWidget *> inSight;
    for (qsizetype i = 0; i < m_docks.size(); ++i) {
        const Panel &panel = panels()[std::size_t(i)];
        const bool isOwn = panel.workspace == workspace;
        const bool isShown = isOwn && panel.atFirst == Panel::AtFirst::Shown;
        if (isShown)
            inSight += m_docks[i];
        QList<QDockWidget *> &place = panel.area == Qt::RightDockWidgetArea ? right : below;
        if (!isOwn)
            foreign += m_docks[i];
        else if (panel.area == Qt::LeftDockWidgetArea)
            m_window->addDockWidget(Qt::LeftDockWidgetArea, m_docks[i]);
        else
            place.insert(isShown ? 0 : place.size(), m_docks[i]);
        m_docks[i]->setVisible(isOwn && panel.atFirst != Panel::AtFirst::Hidden);
    }
    addTogether(Qt::RightDockWidgetArea, right);
    addTogether(Qt::BottomDockWidgetArea, below + foreign);
    for (QDockWidget *dock : std::as_const(inSight))
        dock->raise();
    // Docks have their places only after the window's layout.
    QMetaObject::invokeMethod(
        this,
        [this, inSight] {
            for (QDockWidget *dock : inSight)
                m_room->makeFor(dock);
        },
        Qt::QueuedConnection);
}

/// Adds the panels as tabs of one place.
void FirstArrangement::addTogether(Qt::DockWidgetArea area, const QList<QDockWidget *> &docks)
{
    for (QDockWidget *dock : docks) {
        m_window->addDockWidget(area, dock);
        if (dock != docks.first())
            m_window->tabifyDockWidget(docks.first(), dock);
    }
}

/// Whether panels on both sides would leave the canvas less than half the width.
bool FirstArrangement::isNarrow() const
{
    return m_window->width() < 2 * (m_usual.formulaWidth + leftWidth);
}

/// Puts the panels left of the canvas into one place; in a narrow window, into the formulas' place.
void FirstArrangement::shareLeftPlace()
{
    QDockWidget *first = nullptr;
    for (QDockWidget *dock : std::as_const(m_docks)) {
        if (m_window->dockWidgetArea(dock) != Qt::LeftDockWidgetArea)
            continue;
        if (isNarrow())
            m_window->tabifyDockWidget(m_usual.formula, dock);
        else if (first)
            m_window->tabifyDockWidget(first, dock);
        else
            first = dock;
        dock->hide();
    }
}

FirstArrangement::Sharing FirstArrangement::sharing() const
{
    if (m_window->height() >= spreadHeight)
        return Sharing::Spread;
    return m_window->height() >= pairedHeight ? Sharing::Paired : Sharing::Tabbed;
}

void FirstArrangement::arrangePixelPanels()
{
    const Sharing chosen = sharing();
    const bool isSpread = chosen == Sharing::Spread;
    // The numbers of the assignment need the whole width of a small window.
    m_window->setCorner(Qt::BottomRightCorner,
                        chosen == Sharing::Paired ? Qt::RightDockWidgetArea
                                                  : Qt::BottomDockWidgetArea);
    if (isSpread)
        m_window->splitDockWidget(m_usual.columns, m_usual.pixelHistory, Qt::Horizontal);
    if (chosen == Sharing::Tabbed)
        m_window->tabifyDockWidget(m_usual.formula, m_usual.pixelGrid);
    if (!isSpread)
        m_window->tabifyDockWidget(m_usual.pixelGrid, m_usual.pixelHistory);
}

/// Gives the formulas the height they need, as far as the pixel grid stays legible at its minimum;
/// the other panels of their column share the rest. Without others, the columns below give way.
void FirstArrangement::fitFormula()
{
    const auto *formula = qobject_cast<const FormulaPanel *>(m_usual.formula->widget());
    if (!formula || !isInFront(*m_usual.formula) || m_usual.formula->isFloating()
        || formula->neededHeight() == 0)
        return;
    QList<QDockWidget *> column = {m_usual.formula};
    int others = 0;
    for (QDockWidget *dock : {m_usual.pixelGrid, m_usual.pixelHistory}) {
        // Tabbed docks are all visible to Qt; one of them is counted.
        const QList<QDockWidget *> together = m_window->tabifiedDockWidgets(dock);
        const bool isCounted = std::ranges::any_of(
            column, [&](QDockWidget *counted) { return together.contains(counted); });
        const bool isBeside = dock->isVisible() && !dock->isFloating() && !isCounted
            && m_window->dockWidgetArea(dock) == m_window->dockWidgetArea(m_usual.formula);
        if (!isBeside)
            continue;
        column += dock;
        others += dock->height();
    }
    const int wanted = m_usual.formula->height() - formula->height() + formula->neededHeight();
    if (column.size() == 1)
        return shortenColumns(wanted - m_usual.formula->height());
    const int rest
        = std::max(0, m_usual.formula->height() + others - wanted - DockRoom::tabsHeight);
    QList<int> heights = {wanted};
    for (const QDockWidget *dock : column.sliced(1))
        heights += std::max(1, rest * dock->height() / others);
    m_window->resizeDocks(column, heights, Qt::Vertical);
}

void FirstArrangement::shortenColumns(int lack)
{
    const bool isBelow = m_window->dockWidgetArea(m_usual.columns) == Qt::BottomDockWidgetArea
        && m_window->corner(Qt::BottomRightCorner) == Qt::BottomDockWidgetArea;
    const auto *table = m_usual.columns->findChild<QTableView *>();
    const int rows = leastRows * table->verticalHeader()->defaultSectionSize();
    const int least = m_usual.columns->height() - table->viewport()->height() + rows;
    if (isBelow && lack > 0 && m_usual.columns->height() > least)
        m_window->resizeDocks({m_usual.columns},
                              {std::max(least, m_usual.columns->height() - lack)}, Qt::Vertical);
}

void FirstArrangement::resizeStep()
{
    const int width = m_window->width();
    const int height = m_window->height();
    const int right = std::min(std::max(width * 37 / 100, lineWidth), width / 2 - 8);
    m_window->resizeDocks({m_usual.formula}, {right}, Qt::Horizontal);
    const int columns = std::clamp(m_usual.columns->sizeHint().height(),
                                   height * leastColumns / 100, height * mostColumns / 100);
    m_window->resizeDocks({m_usual.columns}, {columns}, Qt::Vertical);
    if (sharing() == Sharing::Spread)
        m_window->resizeDocks({m_usual.columns, m_usual.pixelHistory}, {width - right, right},
                              Qt::Horizontal);
    const int formulas = m_usual.formula->sizeHint().height();
    m_window->resizeDocks({m_usual.formula, m_usual.pixelGrid}, {formulas, height - formulas},
                          Qt::Vertical);
    fitFormula();
}

} // namespace pixelplumb
