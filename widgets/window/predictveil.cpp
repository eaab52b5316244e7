// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/predictveil.h"

#include "widgets/model/playhead.h"

#include <QEvent>

namespace pixelplumb {

PredictVeil::PredictVeil(const Playhead *playhead, QWidget *panel)
    : QLabel(tr("This panel shows the finished picture. Predict hides it until the run has come to "
                "its end (F5), or Predict is closed."),
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

/// Keeps the veil on top: new children are placed above it.
bool PredictVeil::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::ChildAdded) {
        setGeometry(m_panel->rect());
        raise();
    }
    return QLabel::eventFilter(watched, event);
}

void PredictVeil::follow()
{
    m_panel->setEnabled(!m_playhead->isAheadHidden());
    setGeometry(m_panel->rect());
    setVisible(m_playhead->isAheadHidden());
    raise();
}

} // namespace pixelplumb
