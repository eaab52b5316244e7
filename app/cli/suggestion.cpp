// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/suggestion.h"

#include <algorithm>
#include <vector>

namespace pixelplumb::cli {

namespace {

/// The number of letters to insert, delete, replace or swap with a neighbour to turn one word into
/// the other (Damerau 1964, restricted: no letter is touched twice).
int editDistance(const QString &a, const QString &b)
{
    const auto width = std::size_t(b.size()) + 1;
    std::vector<std::vector<int>> distance(std::size_t(a.size()) + 1, std::vector<int>(width));
    for (std::size_t i = 0; i < distance.size(); ++i) {
        for (std::size_t j = 0; j < width; ++j) {
            if (i == 0 || j == 0) {
                distance[i][j] = int(i + j);
                continue;
            }
            const QChar last = a[qsizetype(i) - 1];
            const QChar otherLast = b[qsizetype(j) - 1];
            distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                                       distance[i - 1][j - 1] + (last == otherLast ? 0 : 1)});
            if (i > 1 && j > 1 && last == b[qsizetype(j) - 2] && otherLast == a[qsizetype(i) - 2])
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
        }
    }
    return distance.back().back();
}

/// The near candidates, nearest first.
QStringList nearestTo(const QString &word, const QStringList &candidates)
{
    constexpr qsizetype longestWord = 60;
    if (word.size() > longestWord)
        return {};
    // One letter is one edit away from every other.
    const int largest = word.size() < 3 ? 0 : std::max(1, int(word.size()) / 3);
    std::vector<std::pair<int, QString>> near;
    for (const QString &candidate : candidates) {
        const bool isBeginning = word.size() >= 3 && candidate.startsWith(word);
        const int distance = isBeginning ? 1 : editDistance(word.toLower(), candidate.toLower());
        if (distance <= largest)
            near.emplace_back(distance, candidate);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    QStringList nearest;
    for (const auto &[distance, candidate] : near)
        nearest += candidate;
    return nearest;
}

} // namespace

QString closestTo(const QString &word, const QStringList &candidates)
{
    return nearestTo(word, candidates).value(0);
}

QString suggestion(const QString &word, const QStringList &candidates)
{
    const QString closest = closestTo(word, candidates);
    return closest.isEmpty() ? QString() : QStringLiteral("; did you mean %1?").arg(closest);
}

InputError unknownName(const QString &place, const QString &what, const QString &word,
                       const QStringList &names)
{
    return {place, QStringLiteral("unknown %1 “%2”").arg(what, word) + suggestion(word, names),
            QStringLiteral("one of ") + names.join(QStringLiteral(", "))};
}

InputError unknownAmongMany(const QString &place, const QString &what, const QString &word,
                            const QStringList &names, const QString &expected)
{
    constexpr qsizetype mostNamed = 3;
    const QStringList nearest = nearestTo(word, names).mid(0, mostNamed);
    const QString meant = nearest.isEmpty()
        ? QString()
        : QStringLiteral("; did you mean %1?").arg(nearest.join(QStringLiteral(" or ")));
    return {place, QStringLiteral("unknown %1 “%2”").arg(what, word) + meant, expected};
}

} // namespace pixelplumb::cli
