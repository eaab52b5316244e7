// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/pareto.h"
#include "widgets/lab/labplot.h"

#include <QtWidgets>

namespace pixelplumb {

class ElidedLabel;
class LabAnswers;
class LabEffects;
class LabFilterMenu;
class LabTable;
class MissPlot;
class ParetoPlot;

/// The charts and tables of the lab, a tab each (objectName "labTabs"). Selecting a contender in
/// one selects it in all.
class LabCharts : public QTabWidget {
    Q_OBJECT

public:
    explicit LabCharts(QWidget *parent = nullptr);

    void show(const SharedResults &results, const QString &family, const ErrorAxis &axis);

    /// The chart of the current tab; null where that is a table.
    LabPlot *chartInFront() const;
    const QString &selected() const { return m_selected; } ///< id; empty where none is

    /// Small, because the window can be small; to read a chart there, float the panel.
    QSize minimumSizeHint() const override { return {240, 88}; }

public slots:
    void select(const QString &contender);

signals:
    void missRequested(const QString &contender); ///< its first wrong pixel

private:
    /// `box`: choices above the shown widget; may be null.
    void addPage(QWidget *box, QWidget *shown, const QString &title, const QString &toolTip);
    void showAll();
    void fillContenders();
    void showMisses();

    ParetoPlot *m_pareto;
    LabTable *m_table;
    LabAnswers *m_answers;
    MissPlot *m_misses;
    LabEffects *m_effects;
    QComboBox *m_contender; ///< whose misses are shown
    LabFilterMenu *m_filter;
    ElidedLabel *m_price; ///< what accuracy costs, in words
    SharedResults m_results;
    SharedResults m_shown; ///< m_results without the contenders that the filter leaves out
    QString m_family;
    const ErrorAxis *m_axis = nullptr;
    QString m_selected;
};

} // namespace pixelplumb
