// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/rowmarkheader.h"

#include "widgets/look/blend.h"
#include "widgets/look/numbertooltip.h"
#include "widgets/look/signs.h"
#include "widgets/model/columntablemodel.h"

#include <QPainter>

namespace pixelplumb {

namespace {

constexpr int markPadding = 6;
constexpr int barWidth = 3;
constexpr float quietShare = 0.3F;

} // namespace

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
    const QString widest
        = tellsPrimitives ? QStringLiteral("▶ △ 000") : withoutMarkup(QStringLiteral("▶ L_00"));
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
                          QStringLiteral("▶"));
    }
    painter->setPen(blended(palette().color(QPalette::WindowText), background, quietShare));
    painter->drawText(rect.adjusted(0, 0, -markPadding, 0), Qt::AlignRight | Qt::AlignVCenter,
                      model()->headerData(section, Qt::Vertical).toString());
    painter->restore();
}

} // namespace pixelplumb
