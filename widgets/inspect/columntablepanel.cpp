// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntablepanel.h"

#include "widgets/inspect/columntable.h"
#include "widgets/model/playhead.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace pixelplumb {

ColumnTablePanel::ColumnTablePanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_table(new ColumnTable(playhead, this))
    , m_summary(new QLabel(this))
{
    setObjectName(QStringLiteral("columnTablePanel"));
    auto *switches = new QHBoxLayout;
    switches->setContentsMargins(8, 0, 8, 0);
    switches->setSpacing(4);
    for (QAction *action : m_table->columnActions()) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setAccessibleName(action->toolTip());
        connect(action, &QAction::visibleChanged, button, // a group that the method has not
                [button, action] { button->setVisible(action->isVisible()); });
        if (action->objectName() == QLatin1String("showExact"))
            switches->addSpacing(16);
        switches->addWidget(button);
    }
    switches->addStretch();
    m_summary->setObjectName(QStringLiteral("columnTableSummary"));
    switches->addWidget(m_summary);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(switches);
    layout->addWidget(m_table);
    setFocusProxy(m_table);

    connect(playhead, &Playhead::tracedChanged, this, &ColumnTablePanel::describe);
    describe();
}

namespace {

QString oneSpan(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return ColumnTablePanel::tr("1 column");
    case SpanAxis::Row:
        return ColumnTablePanel::tr("1 row");
    case SpanAxis::Free:
        break;
    }
    return ColumnTablePanel::tr("1 step");
}

QString severalSpans(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return ColumnTablePanel::tr("%1 columns");
    case SpanAxis::Row:
        return ColumnTablePanel::tr("%1 rows");
    case SpanAxis::Free:
        break;
    }
    return ColumnTablePanel::tr("%1 steps");
}

} // namespace

void ColumnTablePanel::describe()
{
    const TracedScene *traced = m_playhead->traced();
    if (!traced) {
        m_summary->clear();
        return;
    }
    const ScanTrace &trace = *traced->trace;
    QString text = trace.spanCount() == 1 ? oneSpan(m_playhead->axis())
                                          : severalSpans(m_playhead->axis()).arg(trace.spanCount());
    if (trace.primitiveCount() > 1)
        text += QStringLiteral(" · ") + tr("%1 primitives").arg(trace.primitiveCount());
    if (trace.isCut())
        text += QStringLiteral(" · ") + tr("recording ended at its limit");
    m_summary->setText(text);
}

} // namespace pixelplumb
