// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/rowwriter.h"

#include <QStringList>

#include <algorithm>
#include <functional>

namespace pixelplumb {

/// The names of the columns for a number's exact value and for used − exact.
inline QString exactName(const QString &number) { return number + u"_exact"_s; }
inline QString errorName(const QString &number) { return number + u"_error"_s; }

/// A table's columns: each name, and how its cell is read from a row, in one place.
template <class Row>
class TraceTable {
public:
    using Read = std::function<Cell(const Row &row)>;

    /// Ignores a field whose name is already in the table.
    void add(Field field, Read read)
    {
        if (contains(field.name))
            return;
        m_fields.push_back(std::move(field));
        m_reads.push_back(std::move(read));
    }

    const std::vector<Field> &fields() const { return m_fields; }
    bool contains(const QString &name) const { return placeOf(name) < m_fields.size(); }
    std::vector<Cell> cells(const Row &row) const
    {
        std::vector<Cell> cells;
        cells.reserve(m_reads.size());
        for (const Read &read : m_reads)
            cells.push_back(read(row));
        return cells;
    }

    /// The columns with these names, in the order of `names`; unknown names are left out.
    TraceTable only(const QStringList &names) const
    {
        TraceTable chosen;
        for (const QString &name : names) {
            if (const std::size_t place = placeOf(name); place < m_fields.size())
                chosen.add(m_fields[place], m_reads[place]);
        }
        return chosen;
    }
    /// The numbers as the kernel held them, without the exact ones and the errors.
    TraceTable withoutComparisons() const
    {
        TraceTable chosen;
        for (std::size_t i = 0; i < m_fields.size(); ++i) {
            const Field::Kind kind = m_fields[i].kind;
            if (kind != Field::Kind::Exact && kind != Field::Kind::Error)
                chosen.add(m_fields[i], m_reads[i]);
        }
        return chosen;
    }

    /// One more column, followed by all of these.
    TraceTable behind(Field first, Read read) const
    {
        TraceTable all;
        all.add(std::move(first), std::move(read));
        for (std::size_t i = 0; i < m_fields.size(); ++i)
            all.add(m_fields[i], m_reads[i]);
        return all;
    }

private:
    std::size_t placeOf(const QString &name) const
    {
        return std::size_t(std::ranges::find(m_fields, name, &Field::name) - m_fields.begin());
    }

    std::vector<Field> m_fields;
    std::vector<Read> m_reads;
};

} // namespace pixelplumb
