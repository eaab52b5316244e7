// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/textwriter.h"

#include "core/export/numbertext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t rowsOfABlock = 1000;
constexpr int decimals = 6; ///< more where needed to tell a number from a whole one
const QString gap = "  ";

/// A cell in two parts that meet at the same place in all rows: the whole number, right-aligned,
/// and what follows it.
struct AlignedText {
    QString whole;
    QString rest;
};

AlignedText splitNumber(const QString &text)
{
    // A proper fraction is aligned with other fractions: "5 7/54" above "  7/54".
    if (text.contains(u'/') && !text.contains(u' '))
        return {{}, u' ' + text};
    const auto isPartOfWhole = [](QChar letter) { return letter.isDigit() || letter == u'−'; };
    const auto end = std::find_if_not(text.begin(), text.end(), isPartOfWhole) - text.begin();
    return {text.first(end), text.sliced(end)};
}

QString cutText(const Quantity &quantity)
{
    const auto [digits, isCut] = cutDecimal(quantity, decimals);
    return isCut ? digits + u'…' : digits;
}

class TextWriter final : public RowWriter {
public:
    TextWriter(QIODevice &device, TextNumbers numbers)
        : RowWriter(device)
        , m_numbers(numbers)
    {
    }

    void begin(const std::vector<Field> &fields) override
    {
        m_fields = fields;
        m_widths.resize(fields.size());
    }
    void writeRow(const std::vector<Cell> &cells) override
    {
        Q_ASSERT(cells.size() == m_fields.size());
        std::vector<AlignedText> row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row.push_back(textOf(m_fields[i], cells[i]));
            m_widths[i].whole = std::max(m_widths[i].whole, row.back().whole.size());
            m_widths[i].rest = std::max(m_widths[i].rest, row.back().rest.size());
        }
        m_block.push_back(std::move(row));
        if (m_block.size() >= rowsOfABlock)
            putBlock();
    }
    void end() override
    {
        putBlock();
        if (!m_hasHeader)
            putHeader();
    }

private:
    struct Widths {
        qsizetype whole = 0;
        qsizetype rest = 0;
    };

    AlignedText textOf(const Field &field, const Cell &cell) const
    {
        const auto *quantity = std::get_if<Quantity>(&cell);
        if (!quantity)
            return {{}, fileText(field, cell)};
        if (field.kind == Field::Kind::Error)
            return splitNumber(withMinus(decimalText(*quantity)));
        const bool inDecimals
            = m_numbers == TextNumbers::Decimal && quantity->isFinite() && !quantity->isInteger();
        return splitNumber(withMinus(inDecimals ? cutText(*quantity) : toText(*quantity)));
    }

    /// Numbers are aligned to the right end of their titles, texts to the left.
    QString titleOf(const Field &field) const
    {
        return field.title.isEmpty() ? field.name : field.title;
    }
    bool isNumeric(const Field &field) const
    {
        return field.kind != Field::Kind::Text && field.kind != Field::Kind::Boolean;
    }
    qsizetype widthOf(std::size_t i) const
    {
        return std::max(titleOf(m_fields[i]).size(), m_widths[i].whole + m_widths[i].rest);
    }
    QString justified(std::size_t i, const QString &text) const
    {
        return isNumeric(m_fields[i]) ? text.rightJustified(widthOf(i))
                                      : text.leftJustified(widthOf(i));
    }

    void putHeader()
    {
        QStringList cells;
        for (std::size_t i = 0; i < m_fields.size(); ++i)
            cells.append(justified(i, titleOf(m_fields[i])));
        putLine(cells);
        m_hasHeader = true;
    }
    void putBlock()
    {
        if (m_block.empty())
            return;
        if (!m_hasHeader)
            putHeader();
        for (const std::vector<AlignedText> &row : m_block) {
            QStringList cells;
            for (std::size_t i = 0; i < row.size(); ++i)
                cells.append(justified(i,
                                       row[i].whole.rightJustified(m_widths[i].whole)
                                           + row[i].rest.leftJustified(m_widths[i].rest)));
            putLine(cells);
        }
        m_block.clear();
    }
    void putLine(const QStringList &cells)
    {
        QString line = cells.join(gap);
        while (line.endsWith(u' '))
            line.chop(1);
        put(line.toUtf8() + '\n');
    }

    TextNumbers m_numbers;
    std::vector<Field> m_fields;
    std::vector<Widths> m_widths; ///< by field
    std::vector<std::vector<AlignedText>> m_block;
    bool m_hasHeader = false;
};

} // namespace

std::unique_ptr<RowWriter> makeTextWriter(QIODevice &device, TextNumbers numbers)
{
    return std::make_unique<TextWriter>(device, numbers);
}

} // namespace pixelplumb
