// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/rowwriter.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>

#include <cmath>
#include <utility>

namespace pixelplumb {

namespace {

/// A field with a quote, a comma or a line's end stands in quotes, its quotes doubled (RFC 4180,
/// 2).
QByteArray csvCell(const QString &text)
{
    QByteArray cell = text.toUtf8();
    if (!cell.contains('"') && !cell.contains(',') && !cell.contains('\n') && !cell.contains('\r'))
        return cell;
    return '"' + cell.replace('"', "\"\"") + '"';
}

class CsvWriter final : public RowWriter {
public:
    explicit CsvWriter(QIODevice &device)
        : RowWriter(device)
    {
    }

    void begin(const std::vector<Field> &fields) override
    {
        QStringList names;
        for (const Field &field : fields)
            names.append(field.name);
        writeRow(names);
    }
    void writeRow(const QStringList &cells) override
    {
        QByteArray line;
        for (const QString &cell : cells)
            line += csvCell(cell) + ',';
        line.chop(1);
        put(line + "\r\n");
    }
    void end() override { }
};

class JsonWriter final : public RowWriter {
public:
    JsonWriter(QIODevice &device, std::vector<PreambleMember> preamble)
        : RowWriter(device)
        , m_preamble(std::move(preamble))
    {
    }

    void begin(const std::vector<Field> &fields) override
    {
        m_fields = fields;
        QByteArray text = "{\n";
        for (const PreambleMember &member : m_preamble)
            text += "  " + jsonString(member.name) + ": " + member.json + ",\n";
        put(text + "  \"rows\": [");
    }
    void writeRow(const QStringList &cells) override
    {
        QByteArray line = m_first ? "\n    {" : ",\n    {";
        m_first = false;
        for (std::size_t index = 0; index < m_fields.size(); ++index) {
            if (index != 0)
                line += ", ";
            line += jsonString(m_fields[index].name) + ": "
                + value(m_fields[index].kind, cells[qsizetype(index)]);
        }
        put(line + '}');
    }
    void end() override { put(m_first ? "]\n}\n" : "\n  ]\n}\n"); }

private:
    static QByteArray value(Field::Kind kind, const QString &cell)
    {
        if (cell.isEmpty())
            return "null";
        switch (kind) {
        case Field::Kind::Integer:
        case Field::Kind::Boolean:
            return cell.toUtf8();
        case Field::Kind::Real:
            // JSON has no NaN and no infinity.
            return std::isfinite(cell.toDouble()) ? cell.toUtf8() : jsonString(cell);
        case Field::Kind::Text:
            break;
        }
        return jsonString(cell);
    }

    std::vector<PreambleMember> m_preamble;
    std::vector<Field> m_fields;
    bool m_first = true;
};

} // namespace

std::unique_ptr<RowWriter> makeRowWriter(TableFormat format, QIODevice &device,
                                         const std::vector<PreambleMember> &preamble)
{
    if (format == TableFormat::Csv)
        return std::make_unique<CsvWriter>(device);
    return std::make_unique<JsonWriter>(device, preamble);
}

QByteArray jsonString(const QString &text)
{
    const QByteArray array = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return array.sliced(1, array.size() - 2);
}

QString realText(double value)
{
    if (std::isnan(value))
        return QStringLiteral("nan");
    if (std::isinf(value))
        return value < 0 ? QStringLiteral("-inf") : QStringLiteral("inf");
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

} // namespace pixelplumb
