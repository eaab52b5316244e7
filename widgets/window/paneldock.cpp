// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/paneldock.h"

#include "widgets/canvas/canvas.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/window/windowdocks.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pixelplumb {

namespace {

constexpr int lowWindow = 700; ///< logical pixels of height

/// QMainWindow::resizeDocks() takes them for a part of the dock.
int tabsBelow(const QMainWindow &window, const QDockWidget &dock)
{
    for (const QTabBar *bar :
         window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (bar->isVisible()
            && bar->geometry().intersects(dock.geometry().adjusted(0, 0, 0, bar->height())))
            return bar->height();
    }
    return 0;
}

/// Under Wayland a floating dock cannot be moved or docked again before Qt 6.6.
bool canFloat()
{
    return !QGuiApplication::platformName().startsWith(QLatin1String("wayland"))
        || QLibraryInfo::version() >= QVersionNumber(6, 6);
}

/// Covers a panel that shows the finished picture while Predict asks what lies ahead: the panel can
/// be neither seen nor reached by keys. A button beside it ends the run.
class PredictVeil : public QLabel {
public:
    PredictVeil(Playhead *playhead, QWidget *panel)
        : QLabel(PanelDock::tr("This panel shows the finished picture. Predict hides it until the "
                               "run has come to its end (F5), or Predict is closed."),
                 panel)
        , m_playhead(playhead)
        , m_panel(panel)
        , m_finish(pushButton("predictFinish", PanelDock::tr("Finish the run"),
                              PanelDock::tr("Goes to the end, where nothing is left to predict"),
                              panel->parentWidget()))
    {
        setObjectName(u"predictVeil"_s);
        setAlignment(Qt::AlignCenter);
        setWordWrap(true);
        setMargin(16);
        setAutoFillBackground(true);
        panel->installEventFilter(this);
        connect(playhead, &Playhead::aheadHiddenChanged, this, &PredictVeil::follow);
        connect(m_finish, &QPushButton::clicked, playhead,
                [playhead] { playhead->seek(playhead->end()); });
        follow();
    }

protected:
    /// Keeps the veil on top: new children are placed above it.
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move
            || event->type() == QEvent::ChildAdded || event->type() == QEvent::PaletteChange)
            cover();
        return QLabel::eventFilter(watched, event);
    }

private:
    void follow()
    {
        m_panel->setEnabled(!m_playhead->isAheadHidden());
        setVisible(m_playhead->isAheadHidden());
        m_finish->setVisible(m_playhead->isAheadHidden());
        cover();
    }

    void cover()
    {
        QPalette readable = m_panel->palette(); // though the panel is disabled
        readable.setBrush(QPalette::Disabled, QPalette::WindowText,
                          readable.brush(QPalette::Active, QPalette::WindowText));
        setPalette(readable);
        setGeometry(m_panel->rect());
        raise();
        const int below = 2 * fontMetrics().lineSpacing(); // the words, which may be two lines
        m_finish->adjustSize();
        m_finish->move(m_panel->geometry().center() + QPoint(-m_finish->width() / 2, below));
        m_finish->raise();
    }

    Playhead *m_playhead;
    QWidget *m_panel;
    QPushButton *m_finish;
};

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

bool isInFront(const QDockWidget &dock)
{
    return dock.isVisible() && !dock.visibleRegion().isEmpty();
}

DockRoom::DockRoom(QMainWindow *window, const QList<QDockWidget *> &docks, const Usual &usual)
    : QObject(window)
    , m_window(window)
    , m_centre(window->centralWidget())
    , m_docks(docks)
    , m_usual(usual)
{
    window->installEventFilter(this);
    m_centre->installEventFilter(this);
}

/// The window itself receives the clicks between its docks: a separator dragged then stops at the
/// half.
bool DockRoom::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_centre && event->type() == QEvent::Resize && m_centre->width() < half())
        QMetaObject::invokeMethod(this, &DockRoom::keepHalf, Qt::QueuedConnection);
    else if (watched == m_window && event->type() == QEvent::MouseButtonPress)
        m_centre->setMinimumWidth(half());
    else if (watched == m_window && event->type() == QEvent::MouseButtonRelease)
        m_centre->setMinimumWidth(0);
    return QObject::eventFilter(watched, event);
}

/// Half of the window's width, without the separators between the canvas and panels on both sides.
int DockRoom::half() const
{
    return m_window->width() / 2
        - 2 * m_window->style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
}

/// Each panel beside the canvas gives up its share of what the canvas lacks. If one is at its
/// minimum width, the others give the rest when the canvas is resized again.
void DockRoom::keepHalf()
{
    const int taken = m_window->width() - m_centre->width();
    const int left = m_window->width() - half();
    if (taken <= left)
        return;
    QList<QDockWidget *> beside;
    QList<int> widths;
    for (QDockWidget *dock : std::as_const(m_docks)) {
        const Qt::DockWidgetArea area = m_window->dockWidgetArea(dock);
        if ((area != Qt::LeftDockWidgetArea && area != Qt::RightDockWidgetArea)
            || dock->isFloating() || !isInFront(*dock))
            continue;
        beside += dock;
        widths += std::max(1, dock->width() * left / taken);
    }
    m_window->resizeDocks(beside, widths, Qt::Horizontal);
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

/// A study needs more than the columns' first strip: it gets the height it asks for, as far as the
/// canvas keeps 40 % of the window's, or in a low window at most half of it.
void DockRoom::makeBelow(QDockWidget *dock)
{
    if (!studiesBelow().contains(dock))
        return;
    const int wanted = dock->sizeHint().height() + tabsHeight;
    const int before = m_heightBefore.value_or(0);
    const int height = m_window->height();
    const int canvas = m_centre->findChild<Canvas *>()->height();
    const int both = canvas + dock->height() + tabsBelow(*m_window, *dock);
    const int given = height < lowWindow
        ? std::max(std::min(wanted, height / 2), before)
        : std::min(std::max(wanted, before), both - height * 2 / 5);
    m_window->resizeDocks({dock}, {std::max(1, given)}, Qt::Vertical);
}

/// Half of the width stays the canvas's. A panel in the formulas' place gets the height it asks
/// for, as far as the pixel grid keeps its minimum.
void DockRoom::makeBeside(QDockWidget *dock)
{
    if (m_window->dockWidgetArea(dock) == Qt::LeftDockWidgetArea) {
        const int wanted = dock->sizeHint().width();
        if (m_usual.formula->isHidden())
            return m_window->resizeDocks({dock}, {std::min(wanted, m_window->width() * 35 / 100)},
                                         Qt::Horizontal); // the study below needs the width
        const int left = std::max(dock->minimumSizeHint().width(),
                                  std::min(wanted, half() - m_usual.formulaWidth));
        const int right = std::min(m_usual.formula->width(), half() - left);
        return m_window->resizeDocks({dock, m_usual.formula}, {left, right}, Qt::Horizontal);
    }
    if (m_usual.formula->isHidden())
        return m_window->resizeDocks({dock}, {half()}, Qt::Horizontal);
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

/// The studies open below the canvas, in front or not, without the panels that are there at first.
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
    if (!m_heightBefore || m_usual.columns->isHidden() || !studiesBelow().isEmpty())
        return;
    if (!m_usual.columns->isFloating())
        m_window->resizeDocks({m_usual.columns}, {*m_heightBefore}, Qt::Vertical);
    m_heightBefore.reset();
}

} // namespace pixelplumb
