// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntabledelegate.h"

#include "widgets/look/blend.h"
#include "widgets/look/signs.h"
#include "widgets/model/columntablemodel.h"

#include <QPainter>

#include <cmath>

namespace pixelplumb {

namespace {

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
