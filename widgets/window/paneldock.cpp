// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/paneldock.h"

#include "widgets/model/playhead.h"
#include "widgets/window/windowdocks.h"

#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
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

/// Covers a panel that shows the finished picture while Predict asks what lies ahead: the panel can
/// be neither seen nor reached by keys.
class PredictVeil : public QLabel {
public:
    PredictVeil(const Playhead *playhead, QWidget *panel)
        : QLabel(PanelDock::tr("This panel shows the finished picture. Predict hides it until the "
                               "run has come to its end (F5), or Predict is closed."),
                 panel)
        , m_playhead(playhead)
        , m_panel(panel)
    {
        setObjectName(QStringLiteral("predictVeil"));
        setAlignment(Qt::AlignCenter);
        setWordWrap(true);
        setMargin(16);
        setAutoFillBackground(true);
        panel->installEventFilter(this);
        connect(playhead, &Playhead::aheadHiddenChanged, this, &PredictVeil::follow);
        follow();
    }

protected:
    /// Keeps the veil on top: new children are placed above it.
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::ChildAdded) {
            setGeometry(m_panel->rect());
            raise();
        }
        return QLabel::eventFilter(watched, event);
    }

private:
    void follow()
    {
        m_panel->setEnabled(!m_playhead->isAheadHidden());
        setGeometry(m_panel->rect());
        setVisible(m_playhead->isAheadHidden());
        raise();
    }

    const Playhead *m_playhead;
    QWidget *m_panel;
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

} // namespace pixelplumb
