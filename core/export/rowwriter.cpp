// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/rowwriter.h"

#include "core/export/numbertext.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <utility>

namespace pixelplumb {

namespace {

/// A field with a quote, comma or line break is put in quotes, its own quotes doubled (RFC 4180,
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
        m_fields = fields;
        QByteArray line;
        for (const Field &field : fields)
            line += csvCell(field.name) + ',';
        putLine(line);
    }
    void writeRow(const std::vector<Cell> &cells) override
    {
        Q_ASSERT(cells.size() == m_fields.size());
        QByteArray line;
        for (std::size_t i = 0; i < m_fields.size(); ++i)
            line += csvCell(fileText(m_fields[i], cells[i])) + ',';
        putLine(line);
    }
    void end() override { }

private:
    void putLine(const QByteArray &cells) { put(cells.chopped(1) + "\r\n"); }

    std::vector<Field> m_fields;
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
    void writeRow(const std::vector<Cell> &cells) override
    {
        Q_ASSERT(cells.size() == m_fields.size());
        QByteArray line = m_first ? "\n    {" : ",\n    {";
        m_first = false;
        for (std::size_t index = 0; index < m_fields.size(); ++index) {
            if (index != 0)
                line += ", ";
            line += jsonString(m_fields[index].name) + ": " + value(m_fields[index], cells[index]);
        }
        put(line + '}');
    }
    void end() override { put(m_first ? "]\n}\n" : "\n  ]\n}\n"); }

private:
    static QByteArray value(const Field &field, const Cell &cell)
    {
        const QString text = fileText(field, cell);
        if (text.isEmpty())
            return "null";
        const auto *quantity = std::get_if<Quantity>(&cell);
        // JSON has no NaN and no infinity.
        const bool isNumber = quantity && field.kind != Field::Kind::Exact && quantity->isFinite();
        return isNumber || std::holds_alternative<bool>(cell) ? text.toUtf8() : jsonString(text);
    }

    std::vector<PreambleMember> m_preamble;
    std::vector<Field> m_fields;
    bool m_first = true;
};

} // namespace

std::unique_ptr<RowWriter> makeCsvWriter(QIODevice &device)
{
    return std::make_unique<CsvWriter>(device);
}

std::unique_ptr<RowWriter> makeJsonWriter(QIODevice &device, std::vector<PreambleMember> preamble)
{
    return std::make_unique<JsonWriter>(device, std::move(preamble));
}

QString fileText(const Field &field, const Cell &cell)
{
    if (const auto *text = std::get_if<QString>(&cell))
        return *text;
    if (const auto *truth = std::get_if<bool>(&cell))
        return *truth ? u"true"_s : u"false"_s;
    const auto &quantity = std::get<Quantity>(cell);
    return field.kind == Field::Kind::Exact ? fractionText(quantity) : decimalText(quantity);
}

QByteArray jsonString(const QString &text)
{
    const QByteArray array = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return array.sliced(1, array.size() - 2);
}

} // namespace pixelplumb
