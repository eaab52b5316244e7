// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntable.h"
#include "widgets/look/parts.h"
#include "widgets/model/columntablemodel.h"

#include <QtWidgets>

/// Which columns the table shows.
namespace pixelplumb {

void ColumnTable::createActions()
{
    const auto addToggle = [this](const char *name, const QString &text, const QString &toolTip) {
        auto *action = new QAction(text, this);
        action->setObjectName(QString::fromLatin1(name));
        action->setToolTip(toolTip);
        action->setCheckable(true);
        m_columnActions.append(action);
        return action;
    };
    // In the order of NumberGroup.
    m_groupActions = {
        addToggle("showPosition", tr("Position"), tr("Show the column and its half")),
        addToggle("showSpan", tr("Span"), tr("Show where the edges meet the column, and its rows")),
        addToggle("showDecision", tr("Decision"), tr("Show the numbers that decide the samples")),
        addToggle("showEdgeColours", tr("Edge colours"),
                  tr("Show the levels at both edges and where the colours start")),
        addToggle("showColourRates", tr("ΔR ΔG ΔB"), tr("Show the change from sample to sample")),
        addToggle("showFirstColour", tr("First R G B"), tr("Show the levels at the first pixel")),
    };
    // All others have room in a small window.
    for (QAction *action : std::as_const(m_groupActions))
        action->setChecked(action != m_groupActions[int(NumberGroup::EdgeColours)]);
    m_exactAction = addToggle("showExact", tr("Exact"),
                              tr("Show beside each what the same run gives in exact numbers"));
    m_errorAction = addToggle("showError", tr("Error"), tr("Show used minus exact beside each"));
    for (QAction *action : std::as_const(m_columnActions))
        connect(action, &QAction::toggled, this, &ColumnTable::showChosenColumns);
    m_copyAction = named(new QAction(tr("Copy rows"), this), "copyRows");
    connect(m_copyAction, &QAction::triggered, this, &ColumnTable::copySelection);
    m_copyAllAction = named(new QAction(tr("Copy all rows shown"), this), "copyTable");
    connect(m_copyAllAction, &QAction::triggered, this, &ColumnTable::copyAll);
    addActions({m_copyAction, m_copyAllAction});
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

bool ColumnTable::isChosen(int column) const
{
    const NumberDescription &description = m_model->number(column);
    if (description.id == QLatin1String("primitive") && !m_model->hasSeveralPrimitives())
        return false;
    if (!m_groupActions[int(description.group)]->isChecked())
        return false;
    switch (m_model->face(column)) {
    case NumberFace::Used:
        break;
    case NumberFace::Exact:
        return m_exactAction->isChecked();
    case NumberFace::Error:
        return m_errorAction->isChecked();
    }
    return true;
}

bool ColumnTable::hasGroup(NumberGroup group) const
{
    for (int column = 0; column < m_model->columnCount(); ++column) {
        if (m_model->number(column).group == group)
            return true;
    }
    return m_model->columnCount() == 0; // before the first run all columns are shown
}

void ColumnTable::showChosenColumns()
{
    for (int column = 0; column < m_model->columnCount(); ++column)
        setColumnHidden(column, !isChosen(column));
    fitColumns();
}

QList<int> ColumnTable::shownColumns() const
{
    QList<int> columns;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        if (!isColumnHidden(column))
            columns.append(column);
    }
    return columns;
}

void ColumnTable::showColumnMenu(const QPoint &position)
{
    QMenu menu(this);
    menu.addSection(tr("Columns"));
    menu.addActions(m_groupActions);
    menu.addSection(tr("Beside each number"));
    menu.addAction(m_exactAction);
    menu.addAction(m_errorAction);
    menu.addSeparator();
    menu.addActions({m_copyAction, m_copyAllAction});
    menu.exec(position);
}

} // namespace pixelplumb
