// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/dockroom.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QStyle>

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

constexpr int tabsHeight = 40; ///< logical pixels: more than any style's tabs

} // namespace

DockRoom::DockRoom(QMainWindow *window, const QList<QDockWidget *> &docks, const Usual &usual)
    : QObject(window)
    , m_window(window)
    , m_docks(docks)
    , m_usual(usual)
{
}

void DockRoom::makeFor(QDockWidget *dock)
{
    if (dock->isFloating() || dock->isHidden())
        return;
    if (m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
        makeBelow(dock);
    else
        makeBeside(dock);
}

/// A study needs more than the strip that the columns have at first: what it asks for, and no more
/// than half; the canvas keeps the rest.
void DockRoom::makeBelow(QDockWidget *dock)
{
    if (!studiesBelow().contains(dock))
        return;
    const int wanted = std::min(dock->sizeHint().height() + tabsHeight, m_window->height() / 2);
    m_window->resizeDocks({dock}, {std::max(wanted, m_heightBefore.value_or(0))}, Qt::Vertical);
}

/// Half of the width is the canvas's. A panel in the formulas' place has the height that it asks
/// for, but for the pixel grid's least.
void DockRoom::makeBeside(QDockWidget *dock)
{
    const int separators = 2 * m_window->style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
    const int half = m_window->width() / 2 - separators;
    if (m_window->dockWidgetArea(dock) == Qt::LeftDockWidgetArea) {
        const int left = std::max(dock->minimumSizeHint().width(),
                                  std::min(dock->sizeHint().width(), half - m_usual.formulaWidth));
        const int right = std::min(m_usual.formula->width(), half - left);
        return m_window->resizeDocks({dock, m_usual.formula}, {left, right}, Qt::Horizontal);
    }
    const QList<QDockWidget *> inItsPlace = m_window->tabifiedDockWidgets(m_usual.formula);
    if (!inItsPlace.contains(dock) || inItsPlace.contains(m_usual.pixelGrid)
        || m_usual.pixelGrid->isHidden())
        return;
    const int whole = dock->height() + m_usual.pixelGrid->height();
    const int wanted = std::min(dock->sizeHint().height(),
                                whole - m_usual.pixelGrid->minimumSizeHint().height() - tabsHeight);
    if (wanted > dock->height())
        m_window->resizeDocks({dock, m_usual.pixelGrid}, {wanted, whole - wanted}, Qt::Vertical);
}

/// Those that are open below the canvas, in front or not, beside what stands there at first.
QList<QDockWidget *> DockRoom::studiesBelow() const
{
    QList<QDockWidget *> open;
    std::ranges::copy_if(m_docks, std::back_inserter(open), [this](QDockWidget *dock) {
        return dock != m_usual.columns && dock != m_usual.pixelHistory && !dock->isHidden()
            && !dock->isFloating() && m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
    });
    return open;
}

void DockRoom::remember(QDockWidget *dock)
{
    const bool isBelow = m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
    if (isBelow && !m_heightBefore && !m_usual.columns->isHidden()
        && !m_usual.columns->isFloating())
        m_heightBefore = m_usual.columns->height();
}

void DockRoom::giveBack()
{
    if (!m_heightBefore || !studiesBelow().isEmpty())
        return;
    if (!m_usual.columns->isHidden() && !m_usual.columns->isFloating())
        m_window->resizeDocks({m_usual.columns}, {*m_heightBefore}, Qt::Vertical);
    m_heightBefore.reset();
}

} // namespace pixelplumb
