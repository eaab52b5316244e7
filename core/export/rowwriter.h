// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"

#include <QByteArray>
#include <QIODevice>

#include <memory>
#include <variant>
#include <vector>

namespace pixelplumb {

enum class TableFormat {
    Text, ///< aligned, for people
    Csv,
    Json,
};

/// One column of a table.
struct Field {
    enum class Kind {
        Text,
        Number, ///< as the kernel held it; in files a decimal, in JSON a number
        Exact, ///< the exact counterpart; in files a fraction, "277/54", as text
        Error, ///< used − exact; a decimal
        Boolean,
    };

    QString name; ///< "y_B_error"; unique in its table
    Kind kind = Kind::Text;
    QString title = {}; ///< in a text table's header: "⌈y_B⌉"; empty: the name
};

/// The content of a row under a field: a quantity under Number, Exact and Error. An empty text or a
/// none quantity is an empty cell.
using Cell = std::variant<QString, Quantity, bool>;

/// Writes a table row by row, so that millions of rows need no memory. An empty cell is an empty
/// CSV field or JSON's null.
class RowWriter {
public:
    virtual ~RowWriter() = default;

    /// The fields' names are unique.
    virtual void begin(const std::vector<Field> &fields) = 0;
    /// As many cells as there are fields.
    virtual void writeRow(const std::vector<Cell> &cells) = 0;
    virtual void end() = 0;

    /// False after the device refused something.
    bool isOk() const { return m_ok; }

protected:
    explicit RowWriter(QIODevice &device)
        : m_device(device)
    {
    }
    void put(const QByteArray &bytes) { m_ok = m_device.write(bytes) == bytes.size() && m_ok; }

private:
    QIODevice &m_device;
    bool m_ok = true;
};

/// CSV as in RFC 4180, with a header line.
std::unique_ptr<RowWriter> makeCsvWriter(QIODevice &device);

/// JSON as an object with the members of `preamble`, then "rows", an array with one object per row.
struct PreambleMember {
    QString name;
    QByteArray json; ///< its value
};
std::unique_ptr<RowWriter> makeJsonWriter(QIODevice &device, std::vector<PreambleMember> preamble);

/// How a cell is written in files: see Field::Kind.
QString fileText(const Field &field, const Cell &cell);
/// A string in JSON, with its quotes.
QByteArray jsonString(const QString &text);

} // namespace pixelplumb
