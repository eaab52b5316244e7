// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/tableparts.h"

#include "widgets/look/signs.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/columntablemodel.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr int cellPadding = 5;
constexpr int barHeight = 2;

constexpr int markPadding = 6;
constexpr int barWidth = 3;
constexpr float quietShare = 0.3F;

constexpr int leftPadding = 10; // room for the sign of a change
constexpr int rightPadding = 5;
constexpr float currentTint = 0.16F;
constexpr float selectionTint = 0.22F;
constexpr float aheadFade = 0.38F; // keeps 4.5:1 on black and white

QColor backgroundOf(const QStyleOptionViewItem &option, const QModelIndex &index)
{
    const QColor base = option.palette.color(QPalette::Base);
    if (index.data(ColumnTableModel::IsCurrentRole).toBool())
        return blended(base, signColour(Sign::CurrentColumn, option.palette), currentTint);
    if (option.state.testFlag(QStyle::State_Selected))
        return blended(base, option.palette.color(QPalette::Highlight), selectionTint);
    return base;
}

void drawRowMark(QPainter &painter, const QStyleOptionViewItem &option, RowMark mark)
{
    if (mark == RowMark::None)
        return;
    const QColor line = mark == RowMark::PrimitiveBegins ? option.palette.color(QPalette::Text)
                                                         : option.palette.color(QPalette::Mid);
    painter.fillRect(QRect(option.rect.topLeft(), QSize(option.rect.width(), 1)), line);
}

} // namespace

ColumnTableHeader::ColumnTableHeader(QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
{
    setSectionResizeMode(QHeaderView::Fixed);
    setHighlightSections(false);
    setContextMenuPolicy(Qt::CustomContextMenu);
}

QSize ColumnTableHeader::sizeHint() const
{
    return {QHeaderView::sizeHint().width(), fontMetrics().height() + 2 * cellPadding};
}

QString ColumnTableHeader::title(int section) const
{
    return model()->headerData(section, Qt::Horizontal).toString();
}

int ColumnTableHeader::titleWidth(int section) const
{
    return int(std::ceil(SymbolText(title(section)).width(font()))) + 2 * cellPadding;
}

void ColumnTableHeader::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const QString text = title(section);
    const SymbolText symbols(text);
    const std::optional<Sign> edge = edgeSignOf(text);

    painter->save();
    painter->fillRect(rect, palette().color(QPalette::Window));
    if (edge)
        painter->fillRect(rect.left() + cellPadding, rect.bottom() - barHeight,
                          rect.width() - cellPadding, barHeight, signColour(*edge, palette()));
    painter->fillRect(rect.left(), rect.bottom(), rect.width(), 1, palette().color(QPalette::Mid));
    painter->setPen(palette().color(QPalette::WindowText));
    const double baseline = rect.center().y() + fontMetrics().ascent() / 2.0 - 1;
    symbols.draw(*painter,
                 QPointF(rect.right() + 1 - cellPadding - symbols.width(font()), baseline), font());
    painter->restore();
}

RowMarkHeader::RowMarkHeader(QWidget *parent)
    : QHeaderView(Qt::Vertical, parent)
{
    setSectionResizeMode(QHeaderView::Fixed);
    setHighlightSections(false);
    setSectionsClickable(true);
}

QSize RowMarkHeader::sizeHint() const
{
    const auto *table = qobject_cast<const ColumnTableModel *>(model());
    const bool tellsPrimitives = table && table->hasSeveralPrimitives();
    const QString widest = tellsPrimitives ? u"▶ △ 000"_s : withoutMarkup(u"▶ L_00"_s);
    return {fontMetrics().horizontalAdvance(widest) + 2 * markPadding,
            QHeaderView::sizeHint().height()};
}

void RowMarkHeader::paintSection(QPainter *painter, const QRect &rect, int section) const
{
    const QColor background = palette().color(QPalette::Window);
    const QColor plumb = signColour(Sign::CurrentColumn, palette());
    const bool isCurrent
        = model()->index(section, 0).data(ColumnTableModel::IsCurrentRole).toBool();

    painter->save();
    painter->fillRect(rect, background);
    if (isCurrent) {
        painter->fillRect(rect.left(), rect.top(), barWidth, rect.height(), plumb);
        painter->setPen(plumb);
        painter->drawText(rect.adjusted(barWidth + 2, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                          u"▶"_s);
    }
    painter->setPen(blended(palette().color(QPalette::WindowText), background, quietShare));
    painter->drawText(rect.adjusted(0, 0, -markPadding, 0), Qt::AlignRight | Qt::AlignVCenter,
                      model()->headerData(section, Qt::Vertical).toString());
    painter->restore();
}

void ColumnTableDelegate::measure(const QAbstractItemModel &model, const QList<int> &columns,
                                  const std::vector<int> &rows, const QFont &font)
{
    m_layouts.assign(std::size_t(model.columnCount()), {});
    for (const int row : rows) {
        for (const int column : columns)
            m_layouts[std::size_t(column)].include(
                model.index(row, column).data(ColumnTableModel::MeasuredTextRole).toString(), font);
    }
}

int ColumnTableDelegate::cellWidth(int column) const
{
    return leftPadding + int(std::ceil(m_layouts[std::size_t(column)].width())) + rightPadding;
}

void ColumnTableDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                                const QModelIndex &index) const
{
    const QColor background = backgroundOf(option, index);
    const bool isCurrent = index.data(ColumnTableModel::IsCurrentRole).toBool();
    const bool isAhead = index.data(ColumnTableModel::IsAheadRole).toBool();
    QColor text = option.palette.color(QPalette::Text);
    if (isAhead)
        text = blended(text, background, aheadFade);

    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->fillRect(option.rect, background);
    drawRowMark(*painter, option, RowMark(index.data(ColumnTableModel::RowMarkRole).toInt()));
    painter->setFont(option.font);
    const QRectF cell = QRectF(option.rect).adjusted(leftPadding, 0, -rightPadding, 0);
    if (isCurrent && index.data(ColumnTableModel::ChangedRole).toBool()) {
        text = signColour(Sign::Changed, option.palette);
        painter->setPen(text);
        painter->drawText(option.rect.adjusted(1, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                          signGlyph(Sign::Changed));
    }
    painter->setPen(text);
    if (std::size_t(index.column()) < m_layouts.size())
        m_layouts[std::size_t(index.column())].draw(
            *painter, cell, index.data().toString(),
            index.data(ColumnTableModel::MarkedDigitRole).toInt());
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(option.palette.color(QPalette::Highlight));
        painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
    painter->restore();
}

} // namespace pixelplumb
