// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/parts.h"

#include <QtWidgets>

#include <functional>
#include <utility>
#include <vector>

namespace pixelplumb {

/// A column of a table: what it is called, what it means, and the text of a row in it.
template <class Row>
struct RowsColumn {
    using Text = std::function<QString(const Row &)>;
    using More = std::function<QVariant(const Row &, int role)>;

    RowsColumn(const QString &columnTitle, const QString &inWords, Text textOf,
               Qt::AlignmentFlag textSide = Qt::AlignRight, More moreOf = nullptr)
        : title(columnTitle)
        , meaning(inWords)
        , text(std::move(textOf))
        , side(textSide)
        , more(std::move(moreOf))
    {
    }

    QString title;
    QString meaning;
    Text text;
    Qt::AlignmentFlag side;
    More more; ///< anything else about a cell, by role; where it has nothing, the text counts
};

/// Rows of any kind as a table that is only read. Text at the left is in the tool tip as well,
/// since it may be longer than its column.
template <class Row>
class RowsModel final : public QAbstractTableModel {
public:
    static constexpr int SortRole = Qt::UserRole;

    /// `rowName`: the heading of a row; none: rows are numbered from 0.
    RowsModel(std::vector<RowsColumn<Row>> columns, QObject *parent,
              std::function<QString(const Row &)> rowName = {})
        : QAbstractTableModel(parent)
        , m_columns(std::move(columns))
        , m_rowName(std::move(rowName))
    {
    }

    void setRows(std::vector<Row> rows)
    {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
    /// The texts of the same rows have changed.
    void refresh()
    {
        if (!m_rows.empty())
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
    const std::vector<Row> &rows() const { return m_rows; }

    int rowCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : int(m_rows.size());
    }
    int columnCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : int(m_columns.size());
    }
    QVariant data(const QModelIndex &index, int role) const override
    {
        if (!index.isValid() || !checkIndex(index))
            return {};
        const Row &row = m_rows[std::size_t(index.row())];
        const RowsColumn<Row> &column = m_columns[std::size_t(index.column())];
        if (role == Qt::TextAlignmentRole)
            return int(column.side | Qt::AlignVCenter);
        if (const QVariant more = column.more ? column.more(row, role) : QVariant(); more.isValid())
            return more;
        const bool isText = role == Qt::DisplayRole || role == SortRole
            || (role == Qt::ToolTipRole && column.side == Qt::AlignLeft);
        return isText ? column.text(row) : QVariant();
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (section >= (orientation == Qt::Vertical ? rowCount() : columnCount()))
            return {};
        if (orientation == Qt::Vertical && role != Qt::DisplayRole)
            return {};
        if (orientation == Qt::Vertical)
            return m_rowName ? m_rowName(m_rows[std::size_t(section)]) : QString::number(section);
        const RowsColumn<Row> &column = m_columns[std::size_t(section)];
        switch (role) {
        case Qt::DisplayRole:
            return column.title;
        case Qt::ToolTipRole:
            return column.meaning;
        case Qt::TextAlignmentRole:
            return int(column.side | Qt::AlignVCenter);
        default:
            return {};
        }
    }

private:
    std::vector<RowsColumn<Row>> m_columns;
    std::function<QString(const Row &)> m_rowName;
    std::vector<Row> m_rows;
};

/// Makes a table one that is read by rows, in figures of one width and without a frame.
inline void readByRows(QTableView *table)
{
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setFrameShape(QFrame::NoFrame);
    table->setTabKeyNavigation(false);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

} // namespace pixelplumb
