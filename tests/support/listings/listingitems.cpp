// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listingrun.h"

#include <QRegularExpression>

#include <algorithm>

/// The loops over the points and edges of a primitive.
namespace pixelplumb {

/// Points and edges; for edges k those with a condition, and min x_k and max x_k of these.
bool ListingRun::runItems(std::size_t line, const QString &text)
{
    static const QRegularExpression ofItems(
        u"^for each (?:point|edge(?: k)? from) \\((\\S+), (\\S+)\\)"
        "(?: to \\((\\S+), (\\S+)\\))?(?: with (.+))?:$"_s);
    const auto match = ofItems.match(text);
    if (!match.hasMatch())
        return false;
    m_ends = match.capturedTexts().sliced(1, match.captured(3).isEmpty() ? 2 : 4);
    m_met.clear();
    for (std::size_t item = m_first; item < m_end; ++item) {
        enterItem(item, m_ends);
        if (!match.captured(5).isEmpty() && !m_state.holds(match.captured(5)))
            continue;
        m_met.push_back(item);
        runRound(line);
    }
    m_state.setIndex({});
    if (match.captured(5).isEmpty())
        return true;
    std::vector<Number> places = {Number(0)}; // of no edge there are no samples
    if (!m_met.empty())
        places.clear();
    for (const std::size_t item : m_met)
        places.push_back(m_state.valueOf(u"x_%1"_s.arg(item)));
    m_state.set(u"min x_k"_s, std::ranges::min(places));
    m_state.set(u"max x_k"_s, std::ranges::max(places));
    return true;
}

/// The edges come in threes, a triangle's.
bool ListingRun::runTriangles(std::size_t line, const QString &text)
{
    if (text != u"for each triangle, with its three edges:"_s)
        return false;
    for (std::size_t item = 0; item < m_items.size(); item += 3) {
        m_first = item;
        m_end = item + 3;
        runRound(line);
    }
    return true;
}

bool ListingRun::runMetItems(const QString &text)
{
    static const QRegularExpression ofThem(u"^for each edge k of them with ([^:]+): (.+)$"_s);
    const auto match = ofThem.match(text);
    if (!match.hasMatch())
        return false;
    for (const std::size_t item : m_met) {
        enterItem(item, m_ends);
        if (m_state.holds(m_state.meant(match.captured(1))))
            m_state.run(m_state.meant(match.captured(2)));
    }
    m_state.setIndex({});
    return true;
}

void ListingRun::enterItem(std::size_t item, const QStringList &names)
{
    for (qsizetype i = 0; i < names.size(); ++i)
        m_state.set(names[i], m_items[item].at(std::size_t(i)));
    m_state.setIndex(QString::number(item));
    m_state.setExchange(ListingState::Exchange::None);
}

} // namespace pixelplumb
