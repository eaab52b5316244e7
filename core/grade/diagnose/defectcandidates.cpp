// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/defectsearch.h"

#include <algorithm>

/// What is told of the sets of defects that a search has found.
namespace pixelplumb {

namespace {

constexpr std::size_t nearestListed = 5;

} // namespace

std::vector<DiagnosisCandidate> DefectSearch::candidates() const
{
    std::vector<SetMatch> matches = m_exact;
    matches.insert(matches.end(), m_open.begin(), m_open.end());
    matches.insert(matches.end(), m_completed.begin(), m_completed.end());
    std::erase_if(matches, [this](const SetMatch &match) {
        return m_matcher.isByChance(match.set) || m_matcher.drawsNothingTogether(match.set);
    });
    if (matches.empty() && !m_isExplained) {
        for (const SetMatch &near : m_nearest) {
            const bool isNear = isRelevant(near.distance, m_differing) && needsSecond(near);
            if (isNear && !m_matcher.isDrawnAllTheSame(near.set) && !m_matcher.isByChance(near.set)
                && !m_matcher.drawsNothingTogether(near.set))
                matches.push_back(near);
        }
        std::ranges::stable_sort(matches, {}, [this](const SetMatch &near) {
            return std::pair(rankOf(near), near.set.second.has_value());
        });
        matches.resize(std::min(matches.size(), nearestListed));
    }
    std::vector<DiagnosisCandidate> result;
    for (const SetMatch &match : matches)
        result.push_back(candidateOf(match));
    return result;
}

/// Whether two defects together leave clearly less than the better one alone, so that nobody looks
/// for a mistake that is not there.
bool DefectSearch::needsSecond(const SetMatch &near) const
{
    if (!near.set.second)
        return true;
    const std::int64_t alone = leastAlone(near.set);
    return near.distance <= alone - alone / 4;
}

/// In pixels: a pair that leaves hardly less than one of its defects alone ranks with that defect.
std::int64_t DefectSearch::rankOf(const SetMatch &near) const
{
    if (!near.set.second)
        return near.distance;
    const std::int64_t alone = leastAlone(near.set);
    const bool isHardlyLess = alone - near.distance <= 1 || 10 * (alone - near.distance) < alone;
    return isHardlyLess ? alone : near.distance;
}

DiagnosisCandidate DefectSearch::candidateOf(const SetMatch &match) const
{
    DiagnosisCandidate candidate;
    candidate.distance = match.distance;
    candidate.undecidable = match.undecidable;
    candidate.arithmetic = match.set.arithmetic;
    candidate.defects = m_pictures.defectsIn(match.set);
    const bool isTold = candidate.arithmetic
        && (candidate.defects.empty() || !m_matcher.isTolerated(*candidate.arithmetic));
    if (isTold)
        candidate.defects.insert(candidate.defects.begin(),
                                 m_pictures.arithmetics().at(*candidate.arithmetic));
    return candidate;
}

} // namespace pixelplumb
