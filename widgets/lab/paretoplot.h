// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/errorscale.h"
#include "widgets/lab/labplot.h"

#include <QPen>

namespace pixelplumb {

/// What accuracy costs in time (objectName "labPareto"): cost against error, both logarithmic, with
/// rows below for no error at all; the frontier as a staircase, times ×1 by the assignment's
/// method, a hollow dot for each straight loop. A dot's shape and colour tell its arithmetic.
class ParetoPlot : public LabPlot {
    Q_OBJECT

public:
    explicit ParetoPlot(QWidget *parent = nullptr);

    /// axis: a row of errorAxes().
    void show(const SharedResults &results, const QString &family, const ErrorAxis &axis);
    void select(const QString &contender);

    const ParetoChart &chart() const { return m_chart; }
    const ErrorScale &scale() const { return m_scale; }
    /// Where a contender's dot is, in the widget, for programs that click; none without one.
    std::optional<QPointF> positionOf(const QString &contender) const;

    QString textAt(const QPointF &position) const override;

signals:
    void contenderClicked(const QString &contender);

protected:
    void build() override;
    void clickAt(const QPointF &position) override;

private:
    Arithmetic arithmeticOf(const ParetoPoint &point) const;
    QPointF placeOf(const ParetoPoint &point) const; ///< in the plot
    const ParetoPoint *pointAt(const QPointF &position) const;
    QPen missPen() const;
    void setAxes();
    void addStaircase();
    void addPoint(const ParetoPoint &point);
    void addStraight(const ParetoPoint &point);
    void addLabels();
    void addKeys();

    SharedResults m_results;
    QString m_family;
    const ErrorAxis *m_axis = nullptr;
    ParetoChart m_chart;
    ErrorScale m_scale;
    QString m_selected;
};

} // namespace pixelplumb
