// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labresults.h"

#include <QWidget>

#include <functional>
#include <map>

class QCPAbstractPlottable;
class QCPAxis;
class QCPGraph;
class QCPPainter;
class QCustomPlot;

namespace pixelplumb {

/// A chart of the lab: axes and text in the window's palette, a text for what is under the pointer,
/// and the same chart as a figure on paper.
class LabPlot : public QWidget {
    Q_OBJECT

public:
    /// What stands at a place of the chart, as rich text; empty where there is nothing.
    virtual QString textAt(const QPointF &position) const;
    /// What a line of the legend at this place means; empty where there is none.
    QString keyTextAt(const QPointF &position) const;

    /// Above the chart on paper: what it shows, and of which triangles.
    virtual QString figureTitle() const { return accessibleName(); }
    /// What is shown, in figures: the names of the columns, then a line a row.
    virtual std::vector<QStringList> numbers() const = 0;

    /// A figure in light colours, with its title above and paragraphs below that say where it comes
    /// from.
    QByteArray svg(const QStringList &origin);
    QByteArray png(const QStringList &origin);
    /// The numbers, after lines that begin with "# ": the title and where they come from.
    QByteArray csv(const QStringList &origin) const;

    QSize sizeHint() const override { return {640, 280}; }
    QSize minimumSizeHint() const override { return {200, std::max(72, neededHeight())}; }

protected:
    LabPlot(const char *name, const QString &accessibleName, QWidget *parent);

    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

    /// Below which something would be left out, logical pixels; 0 where nothing would.
    virtual int neededHeight() const { return 0; }
    /// Puts everything into the empty plot.
    virtual void build() = 0;
    virtual void clickAt(const QPointF &) { }
    /// Empties the plot and builds it.
    void rebuild();
    /// Gives axes and legend their places: from then on, data can be asked where they stand.
    void layOut();

    QCustomPlot *plot() const { return m_plot; }
    /// So low that what can be read elsewhere leaves its room to the data.
    bool isLow() const;
    /// The title with that of the family; without it where there is none.
    QString titleOn(const SharedResults &results, const QString &family) const;
    /// A word in place of a chart that has nothing to show.
    void addMessage(const QString &text);
    /// A line in the legend, beside the axes, and what it means, for people who point at it.
    void addKey(QCPAbstractPlottable *plottable, const QString &name, const QString &meaning);
    /// One that no data belongs to.
    QCPGraph *addKey(const QString &name, const QString &meaning = {});
    QFont smallFont() const;

    /// A logarithmic axis from `low` to `high`, both above 0, with as many figures as there is room
    /// for; each stands for %1.
    void setLogRange(QCPAxis *axis, double low, double high,
                     const QString &pattern = QStringLiteral("%1")) const;

private:
    void dress();
    void fitLegend();
    void frameFocus();
    QFont titleFont() const;
    QSize sizeOnPaper(const QStringList &origin) const; ///< logical pixels
    void paintFigure(QCPPainter &painter, const QStringList &origin);
    /// With the window's looks and size out of the way.
    void asFigure(const std::function<void()> &paint);

    QCustomPlot *m_plot;
    QPoint m_pressed; ///< where the mouse went down
    std::map<const QCPAbstractPlottable *, QString> m_meanings; ///< of the legend's lines
    bool m_isOnPaper = false;
};

} // namespace pixelplumb
