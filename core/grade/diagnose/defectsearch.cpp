// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/defectsearch.h"

#include "core/grade/rounding/linechoice.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t nearestTried = 64; // whether rounding explains the rest of these sets
constexpr std::size_t nearestPaired = 64; // single defects that are paired with another one
constexpr std::size_t nearestPairedToExplain = 24;
constexpr auto unknown = PictureMatcher::unknown;

} // namespace

DefectSearch::DefectSearch(DefectPictures &pictures, PictureMatcher &matcher,
                           const Diagnosis &diagnosis, const ProgressListener &listener,
                           Sought sought)
    : m_defects(pictures.defects())
    , m_pictures(pictures)
    , m_matcher(matcher)
    , m_listener(listener)
    , m_differing(diagnosis.differing)
    , m_isExplained(diagnosis.verdict == DiagnosisVerdict::Undecidable)
    , m_areRight(
          m_isExplained
          && (matcher.margin().leavesEdgesOpen() || drawsNearestPixels(pictures.scenes().front())))
    , m_mostOpen(matcher.mostOpen())
    , m_mostNear(sought == Sought::NearSets ? std::max(m_mostOpen, m_differing / 10) : m_mostOpen)
    , m_mostPaired(sought == Sought::NearSets ? nearestPaired : nearestPairedToExplain)
{
    const auto count = std::int64_t(m_defects.size());
    m_sets = count * count; // at most: pairs twice
}

/// Once a set explains the pictures, only sets that equal them matter.
std::int64_t DefectSearch::distanceUpTo(const DefectSet &set, std::int64_t limit)
{
    return m_matcher.distance(set, m_isExplained || !m_exact.empty() ? 1 : limit);
}

/// Distances from here on do not matter.
std::int64_t DefectSearch::limit() const
{
    return m_nearest.size() < nearestTried ? std::min(m_mostNear + 1, m_differing)
                                           : m_nearest.back().distance;
}

void DefectSearch::addNear(const DefectSet &set, std::int64_t distance)
{
    if (distance == unknown || distance >= limit())
        return;
    const auto place = std::ranges::upper_bound(m_nearest, distance, {}, &SetMatch::distance);
    m_nearest.insert(place, {set, distance, 0});
    if (m_nearest.size() > nearestTried)
        m_nearest.pop_back();
}

/// Adds a set that leaves only open pixels; false if it leaves others.
bool DefectSearch::addAllowed(const DefectSet &set)
{
    const auto match = m_matcher.allowedMatch(set);
    if (match)
        (match->undecidable == 0 ? m_exact : m_open).push_back(*match);
    return match.has_value();
}

/// Adds those of the near sets that leave only open pixels.
void DefectSearch::explainNearest(bool pairs)
{
    for (const SetMatch &near : m_nearest) {
        if (near.distance > m_mostOpen || near.set.second.has_value() != pairs)
            continue;
        if (!addAllowed(near.set))
            addEqual(near.set);
    }
    std::ranges::stable_sort(m_open, {}, &SetMatch::undecidable);
}

void DefectSearch::addEqual(DefectSet set)
{
    for (const Arithmetic arithmetic : m_matcher.equalIn(set)) {
        set.arithmetic = arithmetic;
        m_exact.push_back({set});
    }
}

/// Tries arithmetics alone; tolerated ones are not reported.
void DefectSearch::tryArithmetics()
{
    addEqual({});
    if (m_isExplained)
        std::erase_if(m_exact, [this](const SetMatch &match) {
            return match.set.arithmetic && m_matcher.isTolerated(*match.set.arithmetic);
        });
}

/// A rule may explain most of the open pixels while rounding explains the rest: takes the nearest
/// of the rules that leave less than half.
void DefectSearch::tryRules()
{
    std::vector<SetMatch> rules;
    for (std::size_t i = 0; i < m_defects.size(); ++i) {
        if (m_defects[i].choice != QLatin1String(ruleChoice))
            continue;
        const std::int64_t most = rules.empty() ? (m_differing - 1) / 2 : rules.front().distance;
        const std::int64_t distance = m_matcher.distance({i}, most + 1);
        if (distance > most)
            continue;
        if (distance < most)
            rules.clear();
        rules.push_back({{i}, distance});
    }
    for (const SetMatch &rule : rules)
        addAllowed(rule.set);
}

bool DefectSearch::trySingles()
{
    for (std::size_t i = 0; i < m_defects.size(); ++i) {
        const bool isNamed = !m_areRight || m_defects[i].isRightAlone
            || m_defects[i].choice == QLatin1String(ruleChoice);
        m_alone.push_back(isNamed ? distanceUpTo({i}, m_differing) : unknown);
        if (m_alone.back() == 0)
            m_exact.push_back({{i}});
        else if (m_exact.empty())
            addNear({i}, m_alone.back());
        if (!goesOnTrying())
            return false;
    }
    tryArithmetics();
    if (m_isExplained && m_exact.empty())
        tryRules();
    if (m_isExplained || !m_exact.empty())
        return true;
    explainNearest(false);
    m_isExplained = !m_exact.empty() || !m_open.empty();
    return true;
}

bool DefectSearch::hasPart(const std::vector<SetMatch> &matches, std::size_t first,
                           std::size_t second) const
{
    return std::ranges::any_of(matches, [&](const SetMatch &match) {
        return match.set.first && !match.set.second
            && (match.set.first == first || match.set.first == second);
    });
}

bool DefectSearch::canBePair(std::size_t first, std::size_t second) const
{
    const Defect &one = m_defects[first];
    const Defect &other = m_defects[second];
    const bool isPlain = !one.standsAlone && !other.standsAlone && !hasPart(m_exact, first, second);
    // Two redrawings together often do what a named defect does.
    const bool areRedrawings
        = one.stage() == DefectStage::Drawing && other.stage() == DefectStage::Drawing;
    return isPlain && !(areRedrawings && m_hasSingle) && canBeTogether(one, other);
}

/// Visits the pairs that a program may have; false where the listener ended it.
bool DefectSearch::forPairs(const std::function<void(const DefectSet &pair)> &examine)
{
    for (std::size_t i = 0; i < m_defects.size(); ++i) {
        for (std::size_t j = i + 1; j < m_defects.size(); ++j) {
            if (!canBePair(i, j))
                continue;
            examine({i, j});
            if (!goesOnTrying())
                return false;
        }
    }
    return true;
}

/// A pair counts only if it needs both defects.
std::int64_t DefectSearch::leastAlone(const DefectSet &pair) const
{
    return std::min(m_alone[*pair.first], m_alone[*pair.second]);
}

/// Tries pairs that equal the pictures first: whether they do is known for pairs already drawn for
/// other submissions. If none does, it tries pairs with a defect that comes near alone.
bool DefectSearch::tryPairs()
{
    m_hasSingle = m_isExplained || !m_exact.empty();
    const bool isDone = forPairs([this](const DefectSet &pair) {
        if (m_matcher.distance(pair, 1) == 0)
            (hasPart(m_open, *pair.first, *pair.second) ? m_completed : m_exact).push_back({pair});
    });
    if (!isDone || m_isExplained || !m_exact.empty())
        return isDone;
    std::vector<std::int64_t> alone = m_alone;
    std::ranges::sort(alone);
    // What explains nothing alone is not near: of rasters all mistakes of colours are such.
    const std::int64_t mostPaired
        = std::min(alone[std::min(m_mostPaired, alone.size()) - 1], m_differing - 1);
    // A pair that leaves more is neither due to rounding nor needs both (needsSecond).
    const auto mostOf = [&](const DefectSet &pair) {
        const std::int64_t least = leastAlone(pair);
        return std::min({std::max(m_mostOpen, least - least / 4) + 1, least, limit()});
    };
    const auto examine = [&](const DefectSet &pair) {
        const std::int64_t distance = m_matcher.distance(pair, mostOf(pair));
        if (distance < leastAlone(pair)
            && (distance <= m_mostOpen || needsSecond({pair, distance})))
            addNear(pair, distance);
    };
    std::vector<SetMatch> estimated; // by spans: the nearest of these are drawn whole
    const bool isDoneAgain = forPairs([&](const DefectSet &pair) {
        if (leastAlone(pair) > mostPaired)
            return;
        const std::int64_t most = mostOf(pair);
        const auto estimate = m_matcher.estimate(pair, most);
        if (!estimate)
            examine(pair);
        else if (*estimate < most)
            estimated.push_back({pair, *estimate});
    });
    if (!isDoneAgain)
        return false;
    std::ranges::stable_sort(estimated, {}, &SetMatch::distance);
    for (const SetMatch &near : estimated) {
        if (near.distance > limit() + limit() / 8)
            break; // limit() never grows
        examine(near.set);
        if (!goesOn(m_listener, {JobPhase::Judging, m_tried, m_sets}))
            return false;
    }
    explainNearest(true);
    if (m_exact.empty() && m_open.empty())
        tryChoices();
    return true;
}

/// Adds to two near defects one that alone is no mistake.
void DefectSearch::tryChoices()
{
    const std::vector<SetMatch> pairs = m_nearest;
    for (const SetMatch &near : pairs) {
        for (std::size_t i = 0; i < m_defects.size() && near.set.second; ++i) {
            const auto isBeside = [&](std::size_t one) {
                return i != one && canBeTogether(m_defects[one], m_defects[i]);
            };
            if (!m_defects[i].isRightAlone || !isBeside(*near.set.first)
                || !isBeside(*near.set.second))
                continue;
            DefectSet set = near.set;
            set.choice = i;
            const std::int64_t distance = m_matcher.distance(set, near.distance);
            if (distance == 0)
                m_exact.push_back({set});
            else if (distance < near.distance && distance <= m_mostOpen)
                addAllowed(set);
        }
    }
    std::ranges::stable_sort(m_open, {}, &SetMatch::undecidable);
}

} // namespace pixelplumb
