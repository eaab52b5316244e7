// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/workspaces.h"

#include "widgets/look/parts.h"
#include "widgets/window/firstarrangement.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr auto currentKey = "workspaces/current";

/// The version changes with the number of panels, so that an old layout is not forced on them;
/// raise the first number when tool bars change.
int layoutVersion() { return 5 * 100 + int(panels().size()); }

/// The settings key of a workspace's layout.
QString keyOf(Workspace workspace) { return u"workspaces/layout%1"_s.arg(int(workspace)); }

/// Drops a panel that is being dragged: restoreState() crashes before that.
void dropDraggedPanel()
{
    QWidget *dragged = QWidget::mouseGrabber();
    if (!qobject_cast<QDockWidget *>(dragged))
        return;
    const QPoint at = QCursor::pos();
    QMouseEvent release(QEvent::MouseButtonRelease, dragged->mapFromGlobal(at), at, Qt::LeftButton,
                        Qt::NoButton, {});
    QCoreApplication::sendEvent(dragged, &release);
}

/// Qt leaves the tab bars of another arrangement in their places, without tabs: their base line
/// would go through a panel.
void clearEmptyTabBars(const QMainWindow &window)
{
    for (QTabBar *bar : window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (bar->count() == 0)
            bar->setGeometry({}); // it gets another one when it is used again
    }
}

} // namespace

Workspaces::Workspaces(QMainWindow *window, FirstArrangement *first, QObject *parent)
    : QObject(parent)
    , m_window(window)
    , m_first(first)
{
}

void Workspaces::goTo(Workspace workspace)
{
    if (workspace == m_current)
        return;
    m_visited += m_current;
    enter(workspace);
}

void Workspaces::goBack()
{
    if (canGoBack())
        enter(m_visited.takeLast());
}

void Workspaces::reset()
{
    for (QToolBar *bar : m_window->findChildren<QToolBar *>())
        bar->show();
    m_first->lay(m_current);
}

void Workspaces::restore(const QSettings &settings)
{
    const int stored = settings.value(QLatin1String(currentKey)).toInt();
    if (stored > 0 && stored < int(std::size(allWorkspaces)))
        m_current = Workspace(stored);
    for (const Workspace each : allWorkspaces)
        kept(each).layout = settings.value(keyOf(each)).toByteArray();
    showCurrent();
    emit changed();
}

void Workspaces::store(QSettings &settings)
{
    keepCurrent();
    settings.setValue(QLatin1String(currentKey), int(m_current));
    for (const Workspace each : allWorkspaces)
        settings.setValue(keyOf(each), kept(each).layout);
}

void Workspaces::keepCurrent()
{
    kept(m_current) = {m_window->saveState(layoutVersion()), m_window->focusWidget()};
}

void Workspaces::showCurrent()
{
    if (!m_window->restoreState(kept(m_current).layout, layoutVersion()))
        m_first->lay(m_current);
}

void Workspaces::enter(Workspace workspace)
{
    emit leaving();
    dropDraggedPanel();
    keepCurrent();
    m_current = workspace;
    m_window->setUpdatesEnabled(false);
    showCurrent();
    m_window->setUpdatesEnabled(true);
    // Returns the focus to the widget that had it in this workspace, else to the canvas.
    QWidget *focus = kept(workspace).focus;
    if (!focus || !focus->isVisible())
        focus = m_window->centralWidget();
    focus->setFocus();
    emit changed();
    QMetaObject::invokeMethod( // panels have their places only after the window's layout
        this, [this] { clearEmptyTabBars(*m_window); }, Qt::QueuedConnection);
}

QString titleOf(Workspace workspace)
{
    switch (workspace) {
    case Workspace::Step:
        return Workspaces::tr("&Step");
    case Workspace::Compare:
        return Workspaces::tr("&Compare");
    case Workspace::Measure:
        return Workspaces::tr("&Measure");
    case Workspace::Grade:
        return Workspaces::tr("&Grade");
    }
    return {};
}

WorkspaceRow::WorkspaceRow(const QList<QAction *> &workspaces, QWidget *parent)
    : QWidget(parent)
{
    named(this, "workspaceRow", tr("Workspaces"));
    auto *layout = withParts(new QHBoxLayout(this), {}, 0);
    layout->setContentsMargins(0, 0, 8, 0);
    for (QAction *action : workspaces) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setObjectName(action->objectName() + u"Button"_s);
        button->setAccessibleName(action->iconText());
        button->setAutoRaise(true);
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
        layout->addWidget(button);
    }
}

QSize WorkspaceRow::minimumSizeHint() const
{
    return {layout()->minimumSize().width(), fontMetrics().height() + 4};
}

} // namespace pixelplumb
