// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/budget.h"
#include "core/lab/study/study.h"
#include "widgets/look/rowsmodel.h"

#include <QTreeWidget>

namespace pixelplumb {

/// The budgets, a row each: the cheapest contender that meets each on a family, and whether it does
/// so by proof or by measurement (objectName "labAnswers").
class LabAnswers : public QTableView {
    Q_OBJECT

public:
    explicit LabAnswers(QWidget *parent = nullptr);

    void show(const Study &study, const QString &family);

protected:
    void resizeEvent(QResizeEvent *event) override;

signals:
    void contenderSelected(const QString &contender);

private:
    struct Row {
        BudgetAnswer answer;
        QString contender; ///< its label
    };
    RowsModel<Row> *m_model;
};

/// What effects cost and correct, a group per scene (objectName "labEffects").
class LabEffects : public QTreeWidget {
    Q_OBJECT

public:
    explicit LabEffects(QWidget *parent = nullptr);

    void show(const Study &study);
};

} // namespace pixelplumb
