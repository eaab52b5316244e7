// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/wholenumber.h"

namespace pixelplumb::cli {

Result<std::int64_t> wholeNumber(const QString &place, const QString &word, const WholeRange &range)
{
    const bool isOpen = range.last == std::numeric_limits<std::int64_t>::max();
    const QString expected = isOpen ? QStringLiteral("%1 or more").arg(range.first)
                                    : QStringLiteral("%1 … %2").arg(range.first).arg(range.last);
    bool isNumber = false;
    const qint64 value = word.toLongLong(&isNumber);
    if (!isNumber)
        return InputError{place, QStringLiteral("“%1” is no whole number").arg(word), expected};
    if (value < range.first || value > range.last)
        return InputError{
            place, QStringLiteral("%1 is %2").arg(QString::number(value), range.outside), expected};
    return std::int64_t(value);
}

Result<std::optional<std::int64_t>> wholeNumberOf(const CommandLine &line, const QString &option,
                                                  const WholeRange &range)
{
    const QString word = line.value(option);
    if (word.isEmpty() && !line.isSet(option))
        return std::optional<std::int64_t>();
    const Result<std::int64_t> number = wholeNumber(QStringLiteral("--") + option, word, range);
    if (!number)
        return number.error();
    return std::optional(*number);
}

} // namespace pixelplumb::cli
