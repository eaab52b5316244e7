// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/symboldelegate.h"

#include "widgets/look/symboltext.h"

#include <QApplication>
#include <QPainter>

namespace pixelplumb {

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
    painter->setClipRect(item.rect);
    painter->setPen(item.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    const QFontMetrics metrics(item.font);
    const double baseline = room.center().y() + (metrics.ascent() - metrics.descent()) / 2.0;
    text.draw(*painter, {double(room.left()), baseline}, item.font);
    painter->restore();
}

} // namespace pixelplumb
