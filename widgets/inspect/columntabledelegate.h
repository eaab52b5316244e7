// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/numberlayout.h"

#include <QStyledItemDelegate>

#include <vector>

namespace pixelplumb {

/// Draws the cells of the column table: digits aligned, the current row in the plumb line's colour,
/// rows not drawn yet dimmed.
class ColumnTableDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Forgets all widths and measures these columns from these rows.
    void measure(const QAbstractItemModel &model, const QList<int> &columns,
                 const std::vector<int> &rows, const QFont &font);
    /// The width that a column's cells need, px.
    int cellWidth(int column) const;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

private:
    std::vector<NumberLayout> m_layouts; ///< by column
};

} // namespace pixelplumb
