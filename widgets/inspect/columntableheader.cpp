// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/columntableheader.h"

#include "widgets/look/symboltext.h"

#include <QPainter>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr int cellPadding = 5;
constexpr int barHeight = 2;

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

} // namespace pixelplumb
