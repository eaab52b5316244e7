// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/symbolitems.h"

#include "widgets/look/typesetting.h"

#include <QApplication>
#include <QStylePainter>

namespace pixelplumb {

namespace {

/// Draws at the left, in the painter's font and pen.
void drawIn(const QRect &room, const SymbolText &text, QPainter *painter)
{
    const QFontMetrics metrics(painter->font());
    const double baseline = room.center().y() + (metrics.ascent() - metrics.descent()) / 2.0;
    painter->setClipRect(room);
    text.draw(*painter, {double(room.left()), baseline}, painter->font());
}

} // namespace

void SymbolDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const SymbolText text(item.text);
    item.text.clear();
    const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    const bool isSelected = item.state.testFlag(QStyle::State_Selected);
    const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &item, item.widget)
                           .adjusted(3, 0, 0, 0);
    painter->save();
    painter->setPen(item.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    painter->setFont(item.font);
    drawIn(room, text, painter);
    painter->restore();
}

SymbolBox::SymbolBox(QWidget *parent)
    : QComboBox(parent)
{
    setItemDelegate(new SymbolDelegate(this));
}

void SymbolBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const QRect room
        = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    painter.setPen(palette().color(QPalette::ButtonText));
    drawIn(room.adjusted(1, 0, -1, 0), SymbolText(currentText()), &painter);
}

} // namespace pixelplumb
