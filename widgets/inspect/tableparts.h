// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/numberlayout.h"

#include <QtWidgets>

#include <vector>

namespace pixelplumb {

class SymbolText;

/// The column table's header: symbols with subscripts, above the bar of the edge to which they
/// belong.
class ColumnTableHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit ColumnTableHeader(QWidget *parent = nullptr);

    QSize sizeHint() const override;
    /// The width that a section's title needs, px.
    int titleWidth(int section) const;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;

private:
    QString title(int section) const;
};

/// The column table's left margin: where a triangle or its second half begins, and the current row.
class RowMarkHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit RowMarkHeader(QWidget *parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
};

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
