// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listinglanguage.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

namespace {

/// "0 ≤ α ≤ 1".
bool holdsChain(const QString &comparison, const ListingNames &names, Arithmetic arithmetic)
{
    const QString signs = u"<≤=≠≥>"_s;
    std::vector<BigRational> values;
    QString between, side;
    const auto end = [&] { values.push_back(valueOf(side.trimmed(), names, arithmetic)); };
    for (const QChar character : comparison) {
        if (!signs.contains(character)) {
            side += character;
            continue;
        }
        end();
        side.clear();
        between += character;
    }
    end();
    if (between.isEmpty())
        throw ListingFault(u"compares nothing: "_s + comparison);
    for (qsizetype i = 0; i < between.size(); ++i) {
        const BigRational &a = values[std::size_t(i)];
        const BigRational &b = values[std::size_t(i) + 1];
        const QChar sign = between[i];
        const bool isTrue = (sign == u'<' && a < b) || (sign == u'≤' && a <= b)
            || (sign == u'=' && a == b) || (sign == u'≠' && a != b) || (sign == u'≥' && a >= b)
            || (sign == u'>' && a > b);
        if (!isTrue)
            return false;
    }
    return true;
}

/// "A > 0, or A = 0 and B > 0".
bool holdsOne(const QString &test, const ListingNames &names, Arithmetic arithmetic)
{
    const QStringList ways = test.split(u", or "_s);
    return std::ranges::any_of(ways, [&](const QString &way) {
        const QString rule = way.section(u" by "_s, 1);
        if (!rule.isEmpty() && !names.contains(rule))
            return false;
        const QStringList comparisons = way.section(u" by "_s, 0, 0).split(u" and "_s);
        return std::ranges::all_of(
            comparisons, [&](const QString &each) { return holdsChain(each, names, arithmetic); });
    });
}

} // namespace

bool holds(const QString &condition, const ListingNames &names, Arithmetic arithmetic)
{
    const QStringList tests = spelledOut(condition);
    return std::ranges::all_of(
        tests, [&](const QString &test) { return holdsOne(test, names, arithmetic); });
}

} // namespace pixelplumb
