// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labrun.h"

#include <QWidget>

#include <functional>
#include <map>

class QCPAbstractPlottable;
class QCPAxis;
class QCPGraph;
class QCPPainter;
class QCustomPlot;

namespace pixelplumb {

/// A chart of the lab: axes and text in the window's palette, a text for the place under the
/// pointer, and the chart as a figure for paper.
class LabPlot : public QWidget {
    Q_OBJECT

public:
    /// Describes what is at a place of the chart, as rich text; empty where there is nothing.
    virtual QString textAt(const QPointF &position) const;
    /// What the legend's line at this place means; empty where there is none.
    QString keyTextAt(const QPointF &position) const;

    /// The title above the figure on paper: what it shows, and of which triangles.
    virtual QString figureTitle() const { return accessibleName(); }

    /// A figure in light colours, with its title above and paragraphs about its origin below.
    QByteArray svg(const QStringList &origin);
    QByteArray png(const QStringList &origin);

    QSize sizeHint() const override { return {640, 280}; }
    QSize minimumSizeHint() const override { return {200, 72}; }

protected:
    LabPlot(const char *name, const QString &accessibleName, QWidget *parent);

    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

    /// Puts everything into the empty plot.
    virtual void build() = 0;
    virtual void clickAt(const QPointF &) { }
    /// Empties the plot and builds it.
    void rebuild();
    /// Lays out axes and legend; after that, positions of data can be queried.
    void layOut();

    QCustomPlot *plot() const { return m_plot; }
    /// Whether the plot is so low that what can be read elsewhere gives its room to the data.
    bool isLow() const;
    /// The chart's title with the family's; alone where there is no family.
    QString titleOn(const SharedResults &results, const QString &family) const;
    /// Adds a text in place of a chart with nothing to show.
    void addMessage(const QString &text);
    /// Adds a line to the legend, beside the axes, with its meaning for people who point at it.
    void addKey(QCPAbstractPlottable *plottable, const QString &name, const QString &meaning);
    /// Adds a legend line without data.
    QCPGraph *addKey(const QString &name, const QString &meaning = {});
    QFont smallFont() const;

    /// Gives a logarithmic axis the range from `low` to `high`, both above 0, with as many numbers
    /// as there is room for; each replaces %1.
    void setLogRange(QCPAxis *axis, double low, double high,
                     const QString &pattern = u"%1"_s) const;

private:
    void fitLegend();
    void frameFocus();
    QFont titleFont() const;
    void paintFigure(QCPPainter &painter, const QStringList &origin);
    /// Paints without the window's colours and size.
    void asFigure(const std::function<void()> &paint);

    QCustomPlot *m_plot;
    std::map<const QCPAbstractPlottable *, QString> m_meanings; ///< of the legend's lines
    bool m_isOnPaper = false;
};

} // namespace pixelplumb
