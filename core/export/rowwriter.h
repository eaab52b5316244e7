// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QStringList>

#include <memory>
#include <vector>

namespace pixelplumb {

enum class TableFormat { Csv, Json };

/// One column of a table that is written to a file.
struct Field {
    /// Text keeps every digit of a rational or a float; Integer and Real are JSON numbers.
    enum class Kind { Text, Integer, Real, Boolean };

    QString name; ///< "y_B_error"
    Kind kind = Kind::Text;
};

/// Writes a table row by row, so that a table of millions of rows needs no memory. An empty cell is
/// an empty CSV field and JSON's null.
class RowWriter {
public:
    virtual ~RowWriter() = default;

    virtual void begin(const std::vector<Field> &fields) = 0;
    /// As many cells as there are fields.
    virtual void writeRow(const QStringList &cells) = 0;
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

/// CSV after RFC 4180, with a header line. JSON as an object whose members are those of `preamble`,
/// then "rows", an array with one object a row.
struct PreambleMember {
    QString name;
    QByteArray json; ///< its value
};
std::unique_ptr<RowWriter> makeRowWriter(TableFormat format, QIODevice &device,
                                         const std::vector<PreambleMember> &preamble);

/// A string in JSON, with its quotes.
QByteArray jsonString(const QString &text);
/// The shortest decimal that reads back as the same double; "nan", "inf" and "-inf" for what has
/// none.
QString realText(double value);

} // namespace pixelplumb
