// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulanames.h"

namespace pixelplumb {

namespace {

constexpr QChar prime = u'′';

bool isSubscript(QChar character)
{
    const char16_t code = character.unicode();
    return (code >= 0x2080 && code <= 0x209C) || (code >= 0x1D62 && code <= 0x1D6A);
}

/// Whether a character can be part of a name. QChar takes ² and ½ for numbers.
bool belongsToName(QChar character)
{
    if (character == u'²' || character == u'½')
        return false;
    return character.isLetterOrNumber() || character == u'_' || isSubscript(character);
}

/// The part to the right of the arrow or the equals sign.
QString rightSideOf(const QString &formula)
{
    for (const QChar sign : {QChar(u'←'), QChar(u'=')}) {
        if (const qsizetype place = formula.indexOf(sign); place >= 0)
            return formula.sliced(place + 1).trimmed();
    }
    return formula.trimmed();
}

} // namespace

void FormulaNames::add(const std::vector<NumberDescription> &columns,
                       const std::vector<Quantity> &cells, const std::vector<Quantity> *earlier)
{
    for (std::size_t i = 0; i < columns.size() && i < cells.size(); ++i) {
        std::optional<Quantity> before;
        if (earlier && i < earlier->size())
            before = (*earlier)[i];
        add(columns[i].title, cells[i], before);
    }
}

const FormulaNames::Entry *FormulaNames::nameAt(const QString &text, qsizetype place,
                                                const QString &ownTitle) const
{
    const Entry *longest = nullptr;
    for (const Entry &entry : m_entries) {
        const qsizetype end = place + entry.title.size();
        if (entry.title == ownTitle && (end >= text.size() || text[end] != prime))
            continue;
        // Of two equal names, the later one.
        if (QStringView(text).sliced(place).startsWith(entry.title)
            && (end == text.size() || !belongsToName(text[end]))
            && (!longest || entry.title.size() >= longest->title.size()))
            longest = &entry;
    }
    return longest;
}

QString FormulaNames::substituted(const QString &formula, const QString &title, int places) const
{
    const QString text = rightSideOf(formula);
    QString result;
    for (qsizetype place = 0; place < text.size();) {
        const bool startsName = place == 0 || !belongsToName(text[place - 1]);
        const Entry *entry = startsName ? nameAt(text, place, title) : nullptr;
        if (!entry) {
            result += text[place++];
            continue;
        }
        qsizetype end = place + entry->title.size();
        const bool isEarlier = end < text.size() && text[end] == prime;
        end += isEarlier ? 1 : 0;
        const Quantity value = isEarlier ? entry->earlier.value_or(Quantity()) : entry->value;
        const bool isAlone = place == 0 && end == text.size();
        if (value.isNone())
            result += text.sliced(place, end - place);
        else
            result += isAlone ? term(value, places) : operand(value, places);
        place = end;
    }
    return result.replace(u"(−0)"_s, u"0"_s);
}

} // namespace pixelplumb
