// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numberformat.h"
#include "widgets/pixelgridpainter.h"
#include "widgets/symboltext.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

/// The pixel grid's words and numbers: axes, y_B and y_T, and the rows that they give.
namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double gap = 4;
constexpr double labelColumn = 132; // beside the cells, for "⌊y_T⌋ = 24"
constexpr double leastGrid = 150; // labels give way to cells below this

const QString upward = QStringLiteral("↑");
const QString downward = QStringLiteral("↓");

/// A name beside the cells at the height of what it names.
struct SpanLabel {
    QString symbol; ///< "y_B = "
    QString value;
    double wish = 0; ///< where its middle would be
    double place = 0; ///< where it is, apart from the others
    Sign sign = Sign::LowerEdge;
};

/// Moves labels apart, in their order, within [top, bottom].
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

QMargins pixelGridMargins(const PixelGridStyle &style, const QSize &area, int largestRowDigits)
{
    const QFontMetricsF metrics(style.font);
    const auto px = [&style](double logical) { return logical * style.scale; };
    const double left = metrics.horizontalAdvance(QString(largestRowDigits, u'0')) + px(2 * gap);
    const double bottom = metrics.height() + px(gap);
    const double top = px(gap);
    const double rest = area.width() - left - std::min(px(labelColumn), double(area.width()));
    const bool hasLabels = rest >= px(leastGrid);
    const double right = hasLabels ? px(labelColumn) : px(gap);
    return {int(std::ceil(left)), int(std::ceil(top)), int(std::ceil(right)),
            int(std::ceil(bottom))};
}

void PixelGridPainter::paintTick(double y, Sign sign)
{
    const QPointF middle = m_mapping.position(double(m_scene.column->x), y);
    const double half = m_mapping.cellSize() * 0.5;
    drawHaloed(QLineF(middle.x() - half, middle.y(), middle.x() + half, middle.y()), colour(sign),
               2);
}

/// ⌈ and ⌊ lie on their side: the bracket closes the covered rows off from outside.
void PixelGridPainter::paintBracket(std::int64_t row, Sign sign)
{
    if (row < m_mapping.firstRow() || row >= m_mapping.endRow())
        return;
    const QRectF cell = m_mapping.cell(QPoint(int(m_scene.column->x), int(row)));
    const bool upwardFrame = m_scene.origin == FrameOrigin::BottomLeft;
    const bool closesBelow = (sign == Sign::LowerEdge) == upwardFrame;
    const double arm = cell.height() * 0.3;
    const double inset = px(0.5);
    const double base = closesBelow ? cell.bottom() - inset : cell.top() + inset;
    const double end = closesBelow ? base - arm : base + arm;
    const QColor bracket = colour(sign);
    drawHaloed(QLineF(cell.left() + inset, base, cell.right() - inset, base), bracket, 2);
    drawHaloed(QLineF(cell.left() + inset, base, cell.left() + inset, end), bracket, 2);
    drawHaloed(QLineF(cell.right() - inset, base, cell.right() - inset, end), bracket, 2);
}

void PixelGridPainter::paintSpan()
{
    if (!m_scene.column)
        return;
    const ColumnRecord &column = *m_scene.column;
    if (column.endRow > column.firstRow) {
        paintBracket(column.firstRow, Sign::LowerEdge);
        paintBracket(column.endRow - 1, Sign::UpperEdge);
    }
    paintTick(column.yBottom.toDouble(), Sign::LowerEdge);
    paintTick(column.yTop.toDouble(), Sign::UpperEdge);
}

void PixelGridPainter::paintAxes()
{
    const QFont font = fontOfSize(m_style.font.pixelSize() / m_style.scale);
    const QFontMetricsF metrics(font);
    const QRect grid = m_mapping.grid();
    const double size = m_mapping.cellSize();
    QFont bold = font;
    bold.setBold(true);
    const auto setPenFor = [&](bool inHand, Sign sign) {
        m_painter.setFont(inHand ? bold : font);
        m_painter.setPen(inHand ? colour(sign) : m_style.palette.color(QPalette::WindowText));
    };
    const auto stepFor = [size](double room) { return std::max(1, int(std::ceil(room / size))); };

    const double widest
        = std::max(metrics.horizontalAdvance(QString::number(m_mapping.firstColumn())),
                   metrics.horizontalAdvance(QString::number(m_mapping.endColumn())));
    const int columnStep = stepFor(widest + px(gap));
    const double baseline = grid.top() + grid.height() + px(2) + metrics.ascent();
    const int middle = m_mapping.firstColumn() + m_mapping.count() / 2;
    for (int x = m_mapping.firstColumn(); x < m_mapping.endColumn(); ++x) {
        const bool inHand = m_scene.column && m_scene.column->x == x;
        if ((x - middle) % columnStep != 0)
            continue;
        setPenFor(inHand, Sign::ColumnInHand);
        const QString text = coordinateText(x);
        const double width = QFontMetricsF(m_painter.font()).horizontalAdvance(text);
        m_painter.drawText(QPointF(m_mapping.position(x, 0).x() - width / 2, baseline), text);
    }
    const int rowStep = stepFor(metrics.height());
    const int middleRow = m_mapping.firstRow() + m_mapping.count() / 2;
    for (int y = m_mapping.firstRow(); y < m_mapping.endRow(); ++y) {
        if ((y - middleRow) % rowStep != 0)
            continue;
        setPenFor(m_scene.picked && m_scene.picked->y() == y, Sign::PickedPixel);
        const QString text = coordinateText(y);
        const double width = QFontMetricsF(m_painter.font()).horizontalAdvance(text);
        m_painter.drawText(QPointF(grid.left() - px(gap) - width,
                                   m_mapping.position(0, y).y() + metrics.capHeight() / 2),
                           text);
    }
}

void PixelGridPainter::paintSpanLabels()
{
    const QRect grid = m_mapping.grid();
    const double left = grid.left() + grid.width();
    const double room = m_painter.viewport().width() - left - px(gap);
    if (!m_scene.column || room < px(labelColumn) - px(2 * gap))
        return;
    const ColumnRecord &column = *m_scene.column;
    const QFontMetricsF metrics(m_style.font);
    const double top = grid.top() + metrics.height() / 2;
    const double bottom = grid.top() + grid.height() - metrics.height() / 2;

    std::vector<SpanLabel> labels;
    const auto add = [&](const QString &symbol, const QString &value, double y, Sign sign) {
        SpanLabel label{symbol + QStringLiteral(" = "), value, m_mapping.position(0, y).y(), 0,
                        sign};
        if (label.wish < grid.top())
            label.value += u' ' + upward;
        else if (label.wish > grid.top() + grid.height())
            label.value += u' ' + downward;
        label.wish = std::clamp(label.wish, top, bottom);
        labels.push_back(label);
    };
    const auto numberText = [&](const Quantity &quantity) {
        QString text = displayText(quantity, m_scene.arithmetic);
        text.replace(QChar(0x2009), QChar(0x00a0)); // at this size a thin space is overlooked
        const double width = metrics.horizontalAdvance(text + QStringLiteral(" y_T = ↑"));
        return width <= room - px(14) ? text : displayDecimal(quantity, 4);
    };
    const QString lastRow = m_scene.fillRule == FillRule::Closed ? QStringLiteral("⌊y_T⌋")
                                                                 : QStringLiteral("⌈y_T⌉−1");
    add(QStringLiteral("y_B"), numberText(column.yBottom), column.yBottom.toDouble(),
        Sign::LowerEdge);
    add(QStringLiteral("y_T"), numberText(column.yTop), column.yTop.toDouble(), Sign::UpperEdge);
    add(QStringLiteral("⌈y_B⌉"), QString::number(column.firstRow), double(column.firstRow),
        Sign::LowerEdge);
    add(lastRow, QString::number(column.endRow - 1), double(column.endRow - 1), Sign::UpperEdge);
    spread(labels, metrics.height() * 1.1, top, bottom);

    m_painter.save();
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    for (const SpanLabel &label : labels) {
        m_painter.setPen(QPen(colour(label.sign), px(1)));
        m_painter.drawLine(QPointF(left + px(2), label.wish), QPointF(left + px(12), label.place));
        const QPointF baseline(left + px(16), label.place + metrics.capHeight() / 2);
        const double width = SymbolText(label.symbol).draw(m_painter, baseline, m_style.font);
        m_painter.setFont(m_style.font);
        m_painter.drawText(baseline + QPointF(width, 0), label.value);
    }
    m_painter.restore();
}

} // namespace pixelplumb
