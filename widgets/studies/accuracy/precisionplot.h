// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/bounderrors.h"
#include "widgets/studies/accuracy/precisionscale.h"

#include <QWidget>

#include <functional>

class QCPItemStraightLine;
class QCustomPlot;

namespace pixelplumb {

/// Which bound's error is plotted: y_B and y_T of columns, x_L and x_R of rows.
enum class PlottedBound { Lower, Upper };

/// The error at this bound, px.
inline double valueOf(const BoundError &error, PlottedBound bound)
{
    return bound == PlottedBound::Lower ? error.lower : error.upper;
}

/// Whether the span's samples end wrongly at this bound.
inline bool isWrongAt(const BoundError &error, PlottedBound bound)
{
    return bound == PlottedBound::Lower ? error.isLowerWrong : error.isUpperWrong;
}

/// The colour and the line style of an arithmetic in plots; either identifies it.
QColor arithmeticColour(Arithmetic arithmetic, const QPalette &palette);
Qt::PenStyle arithmeticLine(Arithmetic arithmetic);

/// Makes an empty plot: the legend beside the axes, not over the curves; `click` hears of clicks,
/// not of drags.
QCustomPlot *makePlot(QWidget *owner, const std::function<void(const QPointF &)> &click);
/// Gives axes, grid and legend the owner's colours and font.
void dressPlot(QCustomPlot &plot, const QWidget &owner);

/// The error of a bound over the columns or rows, one curve per arithmetic, with the limit of
/// accumulated rounding, the half-pixel fences and the first span that covers other samples than it
/// should.
class PrecisionPlot : public QWidget {
    Q_OBJECT

public:
    explicit PrecisionPlot(QWidget *parent = nullptr);

    /// Shows the columns or rows from the first to the last.
    void showPlaces(std::int64_t first, std::int64_t last);
    /// Plots the curves of the `shown` arithmetics.
    void plot(const std::vector<BoundErrors> &errors, PlottedBound bound,
              const std::vector<Arithmetic> &shown);
    /// Sets the current column or row; none removes the plumb line.
    void setCurrentPlace(const std::optional<SpanPlace> &place);

    const PrecisionScale &scale() const { return m_scale; }
    int curveCount() const { return m_curves; }
    /// Where a column or row is drawn; for programs that click.
    QPointF positionOf(std::int64_t coordinate) const;

    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {240, 88}; }

signals:
    void coordinateClicked(std::int64_t coordinate);

private:
    void replot();
    void addCurve(const BoundErrors &errors);
    void addLimit(const BoundErrors &errors);
    void addFirstWrong(const BoundErrors &errors);
    void addFences();

    QCustomPlot *m_plot;
    std::vector<BoundErrors> m_errors; ///< that are shown
    QString m_along; ///< what the spans are
    PlottedBound m_bound = PlottedBound::Lower;
    PrecisionScale m_scale;
    int m_curves = 0;
    std::optional<SpanPlace> m_place;
};

} // namespace pixelplumb
