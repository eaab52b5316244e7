// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "widgets/model/rowfilter.h"

#include <QtCore>

#include <memory>
#include <optional>

namespace pixelplumb {

class Playhead;

/// Which number of its three a column of the table shows: the kernel's, the true one, or their
/// difference.
enum class NumberFace { Used, Exact, Error };

/// What begins at a row.
enum class RowMark { None, PrimitiveBegins, PartBegins };

/// The trace's spans as rows, in drawing order over all primitives: all of them, or those that pass
/// a filter. A reset computes nothing: a row's numbers are taken from the trace when a view asks
/// for them, and cached for the last few rows.
class ColumnTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role {
        /// The number that the cell will show, also while hidden: for its width.
        MeasuredTextRole = Qt::UserRole + 1,
        CanonicalTextRole, ///< of the cell's own face, as `pixelplumb-cli trace` writes it
        ChangedRole, ///< bool: differs from the primitive's previous span
        MarkedDigitRole, ///< int: index of the first character of DisplayRole that differs from the
                         ///< exact number, or −1
        IsAheadRole, ///< bool: the position is before this span
        IsCurrentRole, ///< bool
        RowMarkRole, ///< int of RowMark
        PrimitiveRole, ///< int
    };

    explicit ColumnTableModel(Playhead *playhead, QObject *parent = nullptr);
    ~ColumnTableModel() override;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

    RowFilter filter() const { return m_filter; }
    void setFilter(RowFilter filter);
    /// The span of a row.
    std::size_t spanAt(int row) const;
    /// The row of a span, or of the next span in the table; rowCount() where there is none.
    int rowAt(std::size_t span) const;

    /// The description of a column's number, which holds for all rows.
    const NumberDescription &number(int column) const;
    NumberFace face(int column) const { return m_entries[std::size_t(column)].face; }
    /// "y_B", "y_B_exact", "y_B_error": the column's name in files.
    QString fileName(int column) const;

    /// True where numbers are rounded, so that the exact number and the error are informative.
    bool isRounding() const;
    bool hasSeveralPrimitives() const;

private:
    struct Entry {
        std::size_t number = 0; ///< its index among the method's
        NumberFace face = NumberFace::Used;
    };
    struct RowNumbers {
        SpanRecord used;
        std::vector<Quantity> exact; ///< empty where nothing is rounded
        std::optional<SpanRecord> previous; ///< of the same primitive
    };

    void takeTrace();
    void followPosition();
    const RowNumbers &numbersOf(std::size_t span) const;
    Quantity usedNumber(const RowNumbers &numbers, const Entry &entry) const;
    Quantity exactNumber(const RowNumbers &numbers, const Entry &entry) const;
    QString usedText(const Quantity &used) const;
    QString faceText(const Quantity &used, const Quantity &exact, NumberFace face) const;
    QString canonicalText(const Quantity &used, const Quantity &exact, NumberFace face) const;
    QString toolTip(std::size_t span, const Entry &entry) const;
    QVariant numberData(const RowNumbers &numbers, const Entry &entry, int role) const;
    RowMark markOf(std::size_t span) const;
    bool isToldAhead(int column, int role) const;

    Playhead *m_playhead;
    std::shared_ptr<const TracedScene> m_traced;
    std::vector<NumberDescription> m_numbers; ///< the method's, with the titles of this run
    std::vector<Entry> m_entries;
    std::size_t m_position = 0;
    RowFilter m_filter = RowFilter::All;
    std::vector<std::size_t> m_spans; ///< by row; empty where all are shown
    mutable QCache<std::size_t, RowNumbers> m_cache;
};

} // namespace pixelplumb
