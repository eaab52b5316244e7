// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/pareto.h"
#include "widgets/lab/labelplaces.h"
#include "widgets/lab/labplot.h"

#include <QPen>

class QCPScatterStyle;

namespace pixelplumb {

/// The error axis of the Pareto chart: logarithmic, one decade per unit. Below the decades are rows
/// for an error of 0: as observed, as tested to equal a proved kernel (where there is one), and
/// proved.
class ErrorScale {
public:
    ErrorScale() = default;
    /// Spans whole decades around the errors of class Positive; three decades around 1 where there
    /// are none.
    explicit ErrorScale(const ParetoChart &chart);

    double toAxis(ErrorClass errorClass, double error) const;
    /// The class at a place on the axis; between rows the nearest row's.
    ErrorClass classAt(double axis) const;

    /// The axis' ends.
    static constexpr double bottom = -1;
    double top() const { return double(m_largest - m_least) + decades() + 0.25; }
    /// The line between the rows and the decades.
    double separator() const { return observedRow() + 1; }

    struct Tick {
        double axis = 0;
        QString label; ///< "10⁻³", "0, observed", "0, proved"
    };
    /// The rows, and at most about `most` decades.
    std::vector<Tick> ticks(int most) const;

private:
    static constexpr double provedRow = 0;
    static constexpr double betweenRows = 1.5;
    double testedRow() const { return m_hasTested ? provedRow + betweenRows : provedRow; }
    double observedRow() const { return testedRow() + betweenRows; }
    double decades() const { return separator() + 0.5; } ///< where 10^least is

    int m_least = -1;
    int m_largest = 2;
    bool m_hasTested = false;
};

/// What accuracy costs in time (objectName "labPareto"): cost against error, both logarithmic, with
/// rows below for no error at all. A staircase marks the frontier of the plain kernels, a dashed
/// one that of the SIMD kernels; times are relative to the assignment's method (×1), and each
/// straight loop has a hollow dot. A dot's shape and colour show its arithmetic; contenders without
/// a time yet wait at the left. Left and Right move between dots, Return opens the dot's first
/// wrong pixel.
class ParetoPlot : public LabPlot {
    Q_OBJECT

public:
    explicit ParetoPlot(QWidget *parent = nullptr);

    /// axis: a row of errorAxes().
    void show(const SharedResults &results, const QString &family, const ErrorAxis &axis);
    void select(const QString &contender);
    const QString &selected() const { return m_selected; } ///< id; empty where none is

    const ParetoChart &chart() const { return m_chart; }
    const ErrorScale &scale() const { return m_scale; }
    /// Where a contender's dot is in the widget, for programs that click; none where it has no dot.
    std::optional<QPointF> positionOf(const QString &contender) const;

    QString textAt(const QPointF &position) const override;
    QString figureTitle() const override { return titleOn(m_results, m_family); }

signals:
    void contenderSelected(const QString &contender); ///< by a key
    void contenderClicked(const QString &contender); ///< or activated by Return

protected:
    void build() override;
    void clickAt(const QPointF &position) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// A point of the chart, timed or not, where it is drawn.
    struct Dot {
        ParetoPoint point;
        double cost = 0; ///< on the axis
        double error = 0; ///< on the axis
        bool isTimed = true;
    };

    Arithmetic arithmeticOf(const ParetoPoint &point) const;
    QString textOf(const Dot &dot) const;
    QPointF placeOf(const Dot &dot) const; ///< in the plot
    const Dot *dotOf(const QString &contender) const;
    const Dot *dotAt(const QPointF &position) const;
    QColor staircaseColour(LabKernel kernel) const;
    QPen missPen() const;
    QCPScatterStyle styleOf(const Dot &dot) const;
    void setAxes();
    void setErrorTicks();
    void setWaitingPlaces();
    void addRows();
    void addStaircase(LabKernel kernel);
    void addDot(const Dot &dot);
    void addStraight(const Dot &dot);
    LabelArea labelArea() const;
    void addLabels();
    void addKeys();

    SharedResults m_results;
    QString m_family;
    const ErrorAxis *m_axis = nullptr;
    ParetoChart m_chart;
    ErrorScale m_scale;
    std::vector<Dot> m_dots; ///< the cheapest first, then those without a time
    QString m_selected;
};

} // namespace pixelplumb
