// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labresults.h"

#include <QWidget>

#include <functional>

class QCPAxis;
class QCPGraph;
class QCPLegend;
class QCPPainter;
class QCustomPlot;

namespace pixelplumb {

using SharedResults = std::shared_ptr<const LabResults>;

/// A chart of the lab: axes and text in the window's palette, a text for what is under the pointer,
/// and the same chart as a figure on paper.
class LabPlot : public QWidget {
    Q_OBJECT

public:
    /// What stands at a place of the chart, as rich text; empty where there is nothing.
    virtual QString textAt(const QPointF &position) const;

    /// A figure in light colours, with its title above and lines below that say where it comes
    /// from.
    QByteArray svg(const QString &title, const QStringList &origin);
    QByteArray png(const QString &title, const QStringList &origin);

    QSize sizeHint() const override { return {640, 280}; }
    QSize minimumSizeHint() const override { return {240, 72}; }

protected:
    LabPlot(const char *name, const QString &accessibleName, QWidget *parent);

    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

    /// Puts everything into the empty plot.
    virtual void build() = 0;
    virtual void clickAt(const QPointF &) { }
    /// Empties the plot and builds it.
    void rebuild();

    QCustomPlot *plot() const { return m_plot; }
    /// The legend, beside the axes; shown where anything adds itself.
    QCPLegend *legend() const;
    /// A word in place of a chart that has nothing to show.
    void addMessage(const QString &text);
    /// A line in the legend that no data belongs to.
    QCPGraph *addKey(const QString &text);
    QFont smallFont() const;

    /// A logarithmic axis from `low` to `high`, both above 0; its figures begin with the prefix.
    static void setLogRange(QCPAxis *axis, double low, double high, const QString &prefix = {});

private:
    void dress();
    void paintFigure(QCPPainter &painter, const QString &title, const QStringList &origin);
    /// With the window's looks and size out of the way.
    void asFigure(const std::function<void()> &paint);

    QCustomPlot *m_plot;
    QPoint m_pressed; ///< where the mouse went down
};

} // namespace pixelplumb
