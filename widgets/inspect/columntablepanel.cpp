// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntablepanel.h"

#include "core/runs/spanheadings.h"
#include "widgets/inspect/columntable.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

namespace {

constexpr int leastFilterWidth = 56; // logical pixels

} // namespace

ColumnTablePanel::ColumnTablePanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_table(new ColumnTable(playhead, this))
    , m_summary(new ElidedLabel(this))
{
    setObjectName(u"columnTablePanel"_s);
    auto *switches = withParts(new QHBoxLayout, {}, 4);
    switches->setContentsMargins(8, 0, 8, 0);
    for (QAction *action : m_table->columnActions()) {
        auto *button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setObjectName(action->objectName() + u"Button"_s);
        button->setAccessibleName(action->toolTip());
        connect(action, &QAction::visibleChanged, button, // a group that the method lacks
                [button, action] { button->setVisible(action->isVisible()); });
        if (action->objectName() == QLatin1String("showExact"))
            switches->addSpacing(8);
        switches->addWidget(button);
    }
    switches->addSpacing(8);
    addFilter(switches);
    m_summary->setObjectName(u"columnTableSummary"_s);
    m_summary->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    switches->addWidget(m_summary, 1);

    withParts(new QVBoxLayout(this), {switches, m_table}, 2, 0);
    setFocusProxy(m_table);

    connect(playhead, &Playhead::tracedChanged, this, &ColumnTablePanel::describe);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &ColumnTablePanel::describe);
    describe();
}

void ColumnTablePanel::addFilter(QHBoxLayout *row)
{
    auto *box = new ElidingBox(this);
    m_filter = box;
    named(box, "rowFilterBox", tr("Rows of the table"),
          tr("Show all rows, or those in which a sample lies on an edge (=), a level "
             "went outside 0 … 255 (^), or a pixel differs from the truth (?, !, c)"));
    box->addItems({tr("all rows"), tr("ties ="), tr("clamps ^"), tr("errors ? ! c")}); // RowFilter
    box->setMinimumWidth(leastFilterWidth); // narrower than its text: the canvas needs the room
    connect(box, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_table->setFilter(RowFilter(index));
        describe();
    });
    row->addWidget(box);
}

namespace {

QString titleOf(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return ColumnTablePanel::tr("Columns");
    case SpanAxis::Row:
        return ColumnTablePanel::tr("Rows");
    case SpanAxis::Free:
        break;
    }
    return ColumnTablePanel::tr("Steps");
}

QString countText(SpanAxis axis, int count)
{
    switch (axis) {
    case SpanAxis::Column:
        return ColumnTablePanel::tr("%n columns", nullptr, count);
    case SpanAxis::Row:
        return ColumnTablePanel::tr("%n rows", nullptr, count);
    case SpanAxis::Free:
        break;
    }
    return ColumnTablePanel::tr("%n steps", nullptr, count);
}

} // namespace

void ColumnTablePanel::describe()
{
    const TracedScene *traced = m_playhead->traced();
    const bool hasSpans = traced && traced->trace->spanCount() > 0;
    const SpanAxis axis = hasSpans ? commonAxis(*traced->trace) : SpanAxis::Column;
    setWindowTitle(titleOf(axis));
    m_filter->setVisible(traced); // hidden, it takes no room from the panels laid out before a run
    if (!traced) {
        m_summary->clear();
        return;
    }
    const ScanTrace &trace = *traced->trace;
    QString text = countText(axis, int(trace.spanCount()));
    if (m_table->shownRows() != int(trace.spanCount()))
        text = tr("%1 of %2").arg(m_table->shownRows()).arg(text);
    if (trace.primitiveCount() > 1)
        text += u" · "_s + tr("%n primitives", nullptr, int(trace.primitiveCount()));
    if (trace.isCut())
        text += u" · "_s + tr("recording ended at its limit");
    if (m_playhead->isAheadHidden())
        text = tr("? hidden by Predict") + u" · "_s + text;
    m_summary->setWholeText(text);
}

} // namespace pixelplumb
