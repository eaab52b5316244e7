// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/precisionplot.h"

#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

#include <QtWidgets>
#include <qcustomplot.h>

#include <cmath>
#include <memory>

namespace pixelplumb {

namespace {

constexpr double roundingBound = 0.5;
constexpr int mostTicksPerSide = 6;
constexpr int leastNamedHeight = 140; ///< logical pixels: lower plots do not name the x axis
constexpr int axisMargins = 60; ///< logical pixels above and below the axis, together

} // namespace

QColor arithmeticColour(Arithmetic arithmetic, const QPalette &palette)
{
    constexpr std::array signs // of the rounding ones
        = {Sign::UpperEdge, Sign::LowerEdge, Sign::PickedPixel, Sign::Tie};
    return arithmetic == Arithmetic::Exact
        ? palette.color(QPalette::Text)
        : signColour(signs[std::size_t(arithmetic) - 1], palette);
}

Qt::PenStyle arithmeticLine(Arithmetic arithmetic)
{
    constexpr std::array lines
        = {Qt::SolidLine, Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DashDotDotLine};
    return lines[std::size_t(arithmetic)];
}

QCustomPlot *makePlot(QWidget *owner, const std::function<void(const QPointF &)> &click)
{
    auto *plot = new QCustomPlot(owner);
    withParts(new QVBoxLayout(owner), {plot}, -1, 0);
    plot->setFocusPolicy(Qt::NoFocus);
    auto *beside = new QCPLayoutGrid;
    plot->plotLayout()->addElement(0, 1, beside);
    beside->addElement(0, 0, plot->legend);
    beside->addElement(1, 0, new QCPLayoutElement(plot));
    beside->setRowStretchFactor(0, 0.001);
    plot->plotLayout()->setColumnStretchFactor(1, 0.001);
    const auto pressed = std::make_shared<QPoint>();
    QObject::connect(plot, &QCustomPlot::mousePress, owner,
                     [pressed](const QMouseEvent *event) { *pressed = event->pos(); });
    QObject::connect(plot, &QCustomPlot::mouseRelease, owner,
                     [pressed, click](const QMouseEvent *event) {
                         const QPoint way = event->pos() - *pressed;
                         if (event->button() == Qt::LeftButton && way.manhattanLength() < 4)
                             click(event->position());
                     });
    return plot;
}

void dressPlot(QCustomPlot &plot, const QWidget &owner)
{
    const QColor text = owner.palette().color(QPalette::Text);
    const QBrush base(owner.palette().color(QPalette::Base));
    const QColor lines = translucent(text, 0.2);
    plot.setBackground(base);
    for (QCPAxis *axis : {plot.xAxis, plot.yAxis, plot.xAxis2}) {
        axis->setBasePen(QPen(text));
        axis->setTickPen(QPen(text));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(owner.font());
        axis->setLabelFont(owner.font());
        axis->setLabelPadding(2);
        axis->grid()->setPen(QPen(lines, 0, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(lines, 0, Qt::DotLine));
    }
    plot.legend->setBrush(base);
    plot.legend->setBorderPen(Qt::NoPen);
    plot.legend->setTextColor(text);
    plot.legend->setFont(owner.font());
    plot.legend->setRowSpacing(0);
}

PrecisionPlot::PrecisionPlot(QWidget *parent)
    : QWidget(parent)
    , m_plot(makePlot(this, [this](const QPointF &position) {
        emit coordinateClicked(std::llround(m_plot->xAxis->pixelToCoord(position.x())));
    }))
{
    named(this, "precisionPlot", tr("Error of a bound over the columns"));
    onEvents(this, {QEvent::Resize, QEvent::PaletteChange, QEvent::FontChange},
             [this] { replot(); });
    m_plot->setMinimumSize(minimumSizeHint());
    m_plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_plot->axisRect()->setRangeDrag(Qt::Horizontal);
    m_plot->axisRect()->setRangeZoom(Qt::Horizontal);
}

QPointF PrecisionPlot::positionOf(std::int64_t coordinate) const
{
    const QRect inner = m_plot->axisRect()->rect();
    return {m_plot->xAxis->coordToPixel(double(coordinate)), double(inner.center().y())};
}

void PrecisionPlot::plot(const std::vector<BoundErrors> &errors, PlottedBound bound,
                         const std::vector<Arithmetic> &shown)
{
    const bool isRows = !errors.empty() && !errors.front().spans.empty()
        && errors.front().spans.front().place.axis == SpanAxis::Row;
    m_along = isRows ? tr("row y") : tr("column x");
    m_errors = errors;
    std::erase_if(m_errors, [&shown](const BoundErrors &each) {
        return std::ranges::find(shown, each.arithmetic) == shown.end();
    });
    m_bound = bound;
    replot();
}

void PrecisionPlot::showPlaces(std::int64_t first, std::int64_t last)
{
    m_plot->xAxis->setRange(double(first), double(last) + 1);
}

void PrecisionPlot::setCurrentPlace(const std::optional<SpanPlace> &place)
{
    m_place = place;
    replot();
}

void PrecisionPlot::replot()
{
    m_plot->clearGraphs();
    m_plot->clearItems();
    dressPlot(*m_plot, *this);
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis})
        axis->grid()->setZeroLinePen(QPen(palette().color(QPalette::Text), 1));
    m_curves = 0;
    double smallest = 0;
    double largest = roundingBound;
    for (const BoundErrors &errors : m_errors) {
        for (const BoundError &error : errors.spans) {
            const double magnitude = std::abs(valueOf(error, m_bound));
            if (magnitude > 0 && std::isfinite(magnitude)) {
                smallest = smallest > 0 ? std::min(smallest, magnitude) : magnitude;
                largest = std::max(largest, magnitude);
            }
        }
    }
    m_scale = PrecisionScale(smallest, largest);
    const int perSide
        = std::clamp((height() - axisMargins) / 2 / fontMetrics().height(), 1, mostTicksPerSide);
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    for (const PrecisionScale::Tick &tick : m_scale.ticks(perSide))
        ticker->addTick(tick.axis, tick.label);
    m_plot->yAxis->setTicker(ticker);
    m_plot->yAxis->setRange(-m_scale.extent() - 0.5, m_scale.extent() + 0.5);
    // A low plot has no axis name, which leaves its room to the curves.
    m_plot->xAxis->setLabel(height() < leastNamedHeight ? QString() : m_along);
    m_plot->yAxis->setLabel(tr("error, px"));
    for (const BoundErrors &errors : m_errors) {
        addLimit(errors);
        addCurve(errors);
        addFirstWrong(errors);
    }
    addFences();
    m_plot->legend->setVisible(m_curves > 0);
    m_plot->replot();
}

void PrecisionPlot::addCurve(const BoundErrors &errors)
{
    QVector<double> places;
    QVector<double> values;
    for (const BoundError &error : errors.spans) {
        const double value = valueOf(error, m_bound);
        places.append(double(error.place.coordinate));
        values.append(std::isfinite(value) ? m_scale.toAxis(value) : qQNaN());
    }
    QCPGraph *curve = m_plot->addGraph();
    curve->setName(QString::fromUtf8(nameOf(errors.arithmetic)));
    curve->setPen(QPen(arithmeticColour(errors.arithmetic, palette()), 1.5,
                       arithmeticLine(errors.arithmetic)));
    curve->setData(places, values);
    ++m_curves;
}

void PrecisionPlot::addLimit(const BoundErrors &errors)
{
    const QColor colour = translucent(arithmeticColour(errors.arithmetic, palette()), 0.6);
    for (const int side : {-1, 1}) {
        QVector<double> places;
        QVector<double> values;
        for (const BoundError &error : errors.spans) {
            places.append(double(error.place.coordinate));
            values.append(m_scale.toAxis(side * error.limit));
        }
        QCPGraph *limit = m_plot->addGraph();
        limit->removeFromLegend();
        limit->setPen(QPen(colour, 1, Qt::DotLine));
        limit->setData(places, values);
    }
}

void PrecisionPlot::addFirstWrong(const BoundErrors &errors)
{
    const auto found = std::ranges::find_if(
        errors.spans, [this](const BoundError &error) { return isWrongAt(error, m_bound); });
    if (found == errors.spans.end())
        return;
    const BoundError &wrong = *found;
    const QColor colour = arithmeticColour(errors.arithmetic, palette());
    QCPGraph *mark = m_plot->addGraph();
    mark->removeFromLegend();
    mark->setPen(QPen(colour, 2));
    mark->setLineStyle(QCPGraph::lsNone);
    mark->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCrossCircle, 10));
    mark->setData({double(wrong.place.coordinate)}, {m_scale.toAxis(valueOf(wrong, m_bound))},
                  true);
    auto *label = new QCPItemText(m_plot);
    label->setText(signGlyph(Sign::FirstDifference) + u" %1"_s.arg(wrong.place.coordinate));
    label->setFont(font());
    label->setColor(colour);
    label->setBrush(palette().color(QPalette::Base)); // no line goes through it
    label->setLayer(u"overlay"_s);
    mark->setLayer(u"overlay"_s);
    label->setPadding(QMargins(12, 0, 12, 0));
    // On the side that the plot continues, where the legend does not cover it.
    const double place = double(wrong.place.coordinate);
    const Qt::Alignment side
        = place > m_plot->xAxis->range().center() ? Qt::AlignRight : Qt::AlignLeft;
    label->setPositionAlignment(side | Qt::AlignVCenter);
    label->position->setCoords(place, m_scale.toAxis(valueOf(wrong, m_bound)));
}

void PrecisionPlot::addFences()
{
    const auto line = [this](const QPointF &from, const QPointF &to, const QPen &pen) {
        auto *result = new QCPItemStraightLine(m_plot);
        result->setPen(pen);
        result->point1->setCoords(from);
        result->point2->setCoords(to);
    };
    const QPen fence(palette().color(QPalette::Text), 1, Qt::DashLine);
    for (const double error : {-roundingBound, roundingBound}) {
        const double axis = m_scale.toAxis(error);
        line({0, axis}, {1, axis}, fence);
        auto *label = new QCPItemText(m_plot);
        label->setText(error < 0 ? tr("−½ px") : tr("½ px"));
        label->setFont(font());
        label->setColor(palette().color(QPalette::Text));
        label->setBrush(palette().color(QPalette::Base));
        label->setLayer(u"overlay"_s);
        label->setClipToAxisRect(false);
        label->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
        label->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        label->position->setTypeY(QCPItemPosition::ptPlotCoords);
        label->position->setCoords(0.995, axis);
    }
    if (m_place && m_place->axis != SpanAxis::Free)
        line({double(m_place->coordinate), 0}, {double(m_place->coordinate), 1},
             QPen(signColour(Sign::CurrentColumn, palette()), 1.5));
}

} // namespace pixelplumb
