// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/pixelgridpainter.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/typesetting.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>

/// The pixel grid's labels and numbers: axes, y_B and y_T, and the rows they yield.
namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double gap = 4;
constexpr double labelColumn = 132; // beside the cells, for "⌊y_T⌋ = 24"
constexpr double leastGrid = 150; // below this, labels give way to cells

constexpr double armLength = 0.3; // of a bracket, as a share of the cell

const QString upward = u"↑"_s;
const QString downward = u"↓"_s;

/// A label beside the cells at the height of its object.
struct SpanLabel {
    QString symbol; ///< "y_B = "
    QString value;
    double wish = 0; ///< the ideal middle
    double place = 0; ///< the actual middle, clear of the others
    Sign sign = Sign::LowerEdge;
};

/// Spreads labels within [top, bottom], keeping their order.
void spread(std::vector<SpanLabel> &labels, double distance, double top, double bottom)
{
    std::ranges::stable_sort(labels, {}, &SpanLabel::wish);
    double least = top;
    for (SpanLabel &label : labels) {
        label.place = std::max(label.wish, least);
        least = label.place + distance;
    }
    double most = bottom;
    for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
        label->place = std::min(label->place, most);
        most = label->place - distance;
    }
}

QString coordinateText(int coordinate)
{
    return QString::number(coordinate).replace(u'-', QChar(0x2212));
}

} // namespace

QMargins pixelGridMargins(const PixelGridStyle &style, const QSize &area, int largestRowDigits,
                          BoundsRoom bounds)
{
    const QFontMetricsF metrics(style.font);
    const double left = metrics.horizontalAdvance(QString(largestRowDigits, u'0')) + 2 * gap;
    const double bottom = metrics.height() + gap;
    const double top = gap;
    const double rest = area.width() - left - std::min(labelColumn, double(area.width()));
    const bool hasLabels = bounds == BoundsRoom::Kept && rest >= leastGrid;
    const double right = hasLabels ? labelColumn : gap;
    return {int(std::ceil(left)), int(std::ceil(top)), int(std::ceil(right)),
            int(std::ceil(bottom))};
}

/// Paints ⌈ or ⌊: a bracket that closes off the covered samples.
void PixelGridPainter::paintBracket(FramePainter &frame, std::int64_t along, Sign sign)
{
    const QPoint pixel = m_scene.onSpan(along);
    if (!hasCell(pixel))
        return;
    const QRectF cell = m_mapping.cellOf(pixel).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool isLower = sign == Sign::LowerEdge;
    // The closed side, and the direction from it into the cell.
    QLineF side;
    QPointF arm;
    if (m_scene.span->place.axis == SpanAxis::Row) {
        side = isLower ? QLineF(cell.topLeft(), cell.bottomLeft())
                       : QLineF(cell.topRight(), cell.bottomRight());
        arm = {isLower ? armLength * cell.width() : -armLength * cell.width(), 0};
    } else {
        const bool closesBelow = isLower == (m_scene.origin == FrameOrigin::BottomLeft);
        side = closesBelow ? QLineF(cell.bottomLeft(), cell.bottomRight())
                           : QLineF(cell.topLeft(), cell.topRight());
        arm = {0, closesBelow ? -armLength * cell.height() : armLength * cell.height()};
    }
    for (const QLineF &line :
         {side, QLineF(side.p1(), side.p1() + arm), QLineF(side.p2(), side.p2() + arm)})
        frame.drawCased(line, colour(sign), 2);
}

void PixelGridPainter::paintSpan(FramePainter &frame)
{
    if (!m_scene.hasLine() || m_scene.span->lower.isNone())
        return;
    const SpanRecord &span = *m_scene.span;
    if (span.endSample > span.firstSample) {
        paintBracket(frame, span.firstSample, Sign::LowerEdge);
        paintBracket(frame, span.endSample - 1, Sign::UpperEdge);
    }
    frame.drawEdgeTicks(span, EdgeNames::Hidden);
}

void PixelGridPainter::paintAxes()
{
    const FrameSpec &cells = m_mapping.frame();
    const QFont &font = m_style.font;
    const QFontMetricsF metrics(font);
    const QRectF &grid = m_grid;
    const double size = cellSize();
    QFont bold = font;
    bold.setBold(true);
    const auto setPenFor = [&](bool current, Sign sign) {
        m_painter.setFont(current ? bold : font);
        m_painter.setPen(current ? colour(sign) : m_style.palette.color(QPalette::WindowText));
    };
    const auto isCurrent = [this](SpanAxis axis, int at) {
        return m_scene.hasLine() && m_scene.span->place.axis == axis
            && m_scene.span->place.coordinate == at;
    };
    const auto stepFor = [size](double room) { return std::max(1, int(std::ceil(room / size))); };

    const double widest
        = std::max(metrics.horizontalAdvance(QString::number(cells.firstColumn)),
                   metrics.horizontalAdvance(QString::number((cells.firstColumn + cells.width))));
    const int columnStep = stepFor(widest + gap);
    const double baseline = grid.top() + grid.height() + 2 + metrics.ascent();
    const int middle = cells.firstColumn + cells.width / 2;
    for (int x = cells.firstColumn; x < (cells.firstColumn + cells.width); ++x) {
        const bool current = isCurrent(SpanAxis::Column, x);
        if ((x - middle) % columnStep != 0)
            continue;
        setPenFor(current, Sign::CurrentColumn);
        const QString text = coordinateText(x);
        const double width = QFontMetricsF(m_painter.font()).horizontalAdvance(text);
        m_painter.drawText(QPointF(m_mapping.positionOf(x, 0).x() - width / 2, baseline), text);
    }
    const int rowStep = stepFor(metrics.height());
    const int middleRow = cells.firstRow + cells.height / 2;
    for (int y = cells.firstRow; y < (cells.firstRow + cells.height); ++y) {
        if ((y - middleRow) % rowStep != 0)
            continue;
        if (isCurrent(SpanAxis::Row, y))
            setPenFor(true, Sign::CurrentColumn);
        else
            setPenFor(m_scene.picked && m_scene.picked->y() == y, Sign::PickedPixel);
        const QString text = coordinateText(y);
        const double width = QFontMetricsF(m_painter.font()).horizontalAdvance(text);
        m_painter.drawText(QPointF(grid.left() - gap - width,
                                   m_mapping.positionOf(0, y).y() + metrics.capHeight() / 2),
                           text);
    }
}

void PixelGridPainter::paintSpanLabels()
{
    const QRectF &grid = m_grid;
    const double left = grid.left() + grid.width();
    const double room = m_painter.viewport().width() - left - gap;
    if (m_scene.boundsOf.isEmpty() || room < labelColumn - 2 * gap)
        return;
    const SpanRecord &span = *m_scene.span;
    const bool isRow = span.place.axis == SpanAxis::Row;
    const QFontMetricsF metrics(m_style.font);
    const double lineHeight = metrics.height() * 1.1;
    const double top = grid.top() + metrics.height() / 2 + lineHeight; // below the span's name
    // Below the cells where these are lower than the labels' lines.
    const double bottom
        = std::max(grid.top() + grid.height() - metrics.height() / 2, top + 3 * lineHeight);

    std::vector<SpanLabel> labels;
    const auto add = [&](const QString &symbol, const QString &value, double along, Sign sign) {
        // All labels of a row are at the row.
        const double y = isRow ? double(span.place.coordinate) : along;
        SpanLabel label{symbol + u" = "_s, value, m_mapping.positionOf(0, y).y(), 0, sign};
        if (label.wish < grid.top())
            label.value += u' ' + upward;
        else if (label.wish > grid.top() + grid.height())
            label.value += u' ' + downward;
        label.wish = std::clamp(label.wish, top, bottom);
        labels.push_back(label);
    };
    const auto numberText = [&](const Quantity &quantity) {
        const QString mark = m_scene.areBoundsExact ? coreWord(u"exact"_s) + u'\u00a0' : QString();
        QString text = mark
            + (mark.isEmpty() ? displayText(quantity, m_scene.arithmetic) : displayText(quantity));
        text.replace(QChar(0x2009), QChar(0x00a0)); // at this size a thin space is not noticed
        const double width = metrics.horizontalAdvance(text + u" y_T = ↑"_s);
        return width <= room - 14 ? text : mark + shortDecimal(quantity, 4);
    };
    const QString lower = isRow ? u"x_L"_s : u"y_B"_s;
    const QString upper = isRow ? u"x_R"_s : u"y_T"_s;
    add(lower, numberText(span.lower), span.lower.toDouble(), Sign::LowerEdge);
    add(upper, numberText(span.upper), span.upper.toDouble(), Sign::UpperEdge);
    const auto &[first, last] = m_scene.roundings;
    add(first, QString::number(span.firstSample), double(span.firstSample), Sign::LowerEdge);
    add(last, QString::number(span.endSample - 1), double(span.endSample - 1), Sign::UpperEdge);
    spread(labels, lineHeight, top, bottom);

    m_painter.save();
    m_painter.setFont(m_style.font);
    m_painter.setPen(colour(Sign::CurrentColumn));
    m_painter.drawText(QPointF(left + 16, grid.top() + metrics.ascent()), m_scene.boundsOf);
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    for (const SpanLabel &label : labels) {
        m_painter.setPen(QPen(colour(label.sign), 1));
        m_painter.drawLine(QPointF(left + 2, label.wish), QPointF(left + 12, label.place));
        const QPointF baseline(left + 16, label.place + metrics.capHeight() / 2);
        const double width = SymbolText(label.symbol).draw(m_painter, baseline, m_style.font);
        m_painter.setFont(m_style.font);
        m_painter.drawText(baseline + QPointF(width, 0), label.value);
    }
    m_painter.restore();
}

} // namespace pixelplumb
