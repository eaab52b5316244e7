// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"

#include "core/grade/picturediff.h"
#include "core/grade/undecidable.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t nearestListed = 5;
constexpr std::size_t nearestTried = 64; // of sets, whether rounding may decide what they leave
constexpr auto unknown = PictureMatcher::unknown;

/// Whether what differs lies on ties and within the bound of the tolerance alone.
bool isUndecidable(DefectPictures &pictures, std::span<const FoundPicture> found,
                   std::optional<Arithmetic> tolerance)
{
    return tolerance && std::ranges::all_of(found, [&](const FoundPicture &each) {
               const Picture &right = *pictures.picture(each.scene, {});
               return differenceOf(right, each.picture,
                                   undecidablePixels(pictures.scenes()[each.scene], right,
                                                     each.picture, *tolerance))
                          .differing()
                   == 0;
           });
}

/// Tries sets of one and of two defects.
class DefectSearch {
public:
    /// It explains pictures that differ in so many pixels from the right ones, which may do without
    /// an explanation.
    DefectSearch(DefectPictures &pictures, PictureMatcher &matcher, const Diagnosis &diagnosis,
                 const ProgressListener &listener)
        : m_defects(pictures.defects())
        , m_pictures(pictures)
        , m_matcher(matcher)
        , m_listener(listener)
        , m_differing(diagnosis.differing)
        , m_isExplained(diagnosis.verdict == DiagnosisVerdict::Undecidable)
        , m_mostOpen(matcher.coveredPixels() / 8 + 8)
    {
        const auto count = std::int64_t(m_defects.size());
        m_sets = count * (count + 1) / 2; // at most
    }

    /// False where the listener ended it.
    bool run() { return trySingles() && tryPairs(); }

    std::vector<DiagnosisCandidate> candidates() const
    {
        std::vector<SetMatch> matches = m_exact;
        matches.insert(matches.end(), m_open.begin(), m_open.end());
        matches.insert(matches.end(), m_completed.begin(), m_completed.end());
        if (matches.empty() && !m_isExplained)
            std::ranges::copy(std::span(m_nearest).first(std::min(m_nearest.size(), nearestListed)),
                              std::back_inserter(matches));
        std::vector<DiagnosisCandidate> result;
        for (const SetMatch &match : matches)
            result.push_back(candidateOf(match));
        return result;
    }

private:
    DiagnosisCandidate candidateOf(const SetMatch &match) const
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

    bool goesOnTrying() { return goesOn(m_listener, {JobPhase::Judging, ++m_tried, m_sets}); }

    /// Once a set explains the pictures, only others that equal them are of interest.
    std::int64_t distanceUpTo(const DefectSet &set, std::int64_t limit)
    {
        return m_matcher.distance(set, m_isExplained || !m_exact.empty() ? 1 : limit);
    }

    /// From here on a distance is of no interest.
    std::int64_t limit() const
    {
        return m_nearest.size() < nearestTried ? m_differing : m_nearest.back().distance;
    }

    void addNear(const DefectSet &set, std::int64_t distance)
    {
        if (distance == unknown || distance >= limit())
            return;
        const auto place = std::ranges::upper_bound(m_nearest, distance, {}, &SetMatch::distance);
        m_nearest.insert(place, {set, distance, 0});
        if (m_nearest.size() > nearestTried)
            m_nearest.pop_back();
    }

    /// Of sets that come near, those that leave nothing but what may be either way.
    void explainNearest(bool pairs)
    {
        for (const SetMatch &near : m_nearest) {
            if (near.distance > m_mostOpen || near.set.second.has_value() != pairs)
                continue;
            if (const auto match = m_matcher.allowedMatch(near.set))
                (match->undecidable == 0 ? m_exact : m_open).push_back(*match);
            else
                addEqual(near.set);
        }
        std::ranges::stable_sort(m_open, {}, &SetMatch::undecidable);
    }

    void addEqual(DefectSet set)
    {
        for (const Arithmetic arithmetic : m_matcher.equalIn(set)) {
            set.arithmetic = arithmetic;
            m_exact.push_back({set});
        }
    }

    /// What is computed in, alone: nobody is told what is allowed for.
    void tryArithmetics()
    {
        addEqual({});
        if (m_isExplained)
            std::erase_if(m_exact, [this](const SetMatch &match) {
                return match.set.arithmetic && m_matcher.isTolerated(*match.set.arithmetic);
            });
    }

    bool trySingles()
    {
        for (std::size_t i = 0; i < m_defects.size(); ++i) {
            m_alone.push_back(distanceUpTo({i}, m_differing));
            if (m_alone.back() == 0)
                m_exact.push_back({{i}});
            else if (m_exact.empty())
                addNear({i}, m_alone.back());
            if (!goesOnTrying())
                return false;
        }
        tryArithmetics();
        if (m_isExplained || !m_exact.empty())
            return true;
        explainNearest(false);
        m_isExplained = !m_exact.empty() || !m_open.empty();
        return true;
    }

    bool hasPart(const std::vector<SetMatch> &matches, std::size_t first, std::size_t second) const
    {
        return std::ranges::any_of(matches, [&](const SetMatch &match) {
            return match.set.first && !match.set.second
                && (match.set.first == first || match.set.first == second);
        });
    }

    bool canBePair(std::size_t first, std::size_t second) const
    {
        const Defect &one = m_defects[first];
        const Defect &other = m_defects[second];
        const bool isOneChoice = !one.choice.isEmpty() && one.choice == other.choice;
        return !isOneChoice && !one.standsAlone && !other.standsAlone
            && !hasPart(m_exact, first, second);
    }

    bool tryPairs()
    {
        for (std::size_t i = 0; i < m_defects.size(); ++i) {
            for (std::size_t j = i + 1; j < m_defects.size(); ++j) {
                if (!canBePair(i, j))
                    continue;
                // A pair is one where each of the two is needed.
                const std::int64_t least = std::min(m_alone[i], m_alone[j]);
                const std::int64_t distance = distanceUpTo({i, j}, std::min(least, limit()));
                if (distance == 0)
                    (hasPart(m_open, i, j) ? m_completed : m_exact).push_back({{i, j}});
                else if (distance < least && m_exact.empty() && !m_isExplained)
                    addNear({i, j}, distance);
                if (!goesOnTrying())
                    return false;
            }
        }
        if (!m_isExplained && m_exact.empty())
            explainNearest(true);
        return true;
    }

    const std::vector<Defect> &m_defects;
    DefectPictures &m_pictures;
    PictureMatcher &m_matcher;
    const ProgressListener &m_listener;
    std::int64_t m_differing;
    bool m_isExplained; ///< by what is right, or by a set with pixels that are left open
    std::int64_t m_mostOpen; ///< pixels: more are never a matter of rounding alone
    std::int64_t m_sets = 0, m_tried = 0;
    std::vector<std::int64_t> m_alone; ///< distances, by defect
    std::vector<SetMatch> m_exact, m_open;
    std::vector<SetMatch> m_completed; ///< pairs that are exact, one of which leaves open pixels
    std::vector<SetMatch> m_nearest; ///< ascending
};

} // namespace

QString nameOf(DiagnosisVerdict verdict)
{
    switch (verdict) {
    case DiagnosisVerdict::Right:
        return QStringLiteral("right");
    case DiagnosisVerdict::Undecidable:
        return QStringLiteral("undecidable");
    case DiagnosisVerdict::Wrong:
        break;
    }
    return QStringLiteral("wrong");
}

QStringList DiagnosisCandidate::ids() const
{
    QStringList ids;
    for (const Defect &defect : defects)
        ids += defect.id;
    return ids;
}

QStringList DiagnosisCandidate::sentences(QString Defect::*words) const
{
    QStringList sentences;
    for (const Defect &defect : defects) {
        if (!sentences.contains(defect.*words))
            sentences += defect.*words;
    }
    return sentences;
}

QString pixelsText(std::int64_t pixels)
{
    return pixels == 1 ? QStringLiteral("1 pixel") : QStringLiteral("%1 pixels").arg(pixels);
}

QString undecidableText(std::int64_t pixels)
{
    return pixels == 0
        ? QString()
        : QStringLiteral("but for %1 that rounding or a sample on an edge may decide")
              .arg(pixelsText(pixels));
}

std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener,
                                  std::optional<Arithmetic> tolerance)
{
    std::vector<Scene> scenes;
    std::vector<FoundPicture> found;
    for (const Submission &submission : submissions) {
        found.push_back({scenes.size(), submission.picture});
        scenes.push_back(submission.scene);
    }
    DefectPictures pictures(std::move(scenes));
    return diagnose(pictures, found, listener, tolerance);
}

std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener,
                                  std::optional<Arithmetic> tolerance)
{
    Diagnosis diagnosis;
    PictureMatcher matcher(pictures, found, tolerance);
    diagnosis.differing = matcher.distance({});
    if (diagnosis.differing == 0) {
        diagnosis.verdict = DiagnosisVerdict::Right;
        return diagnosis;
    }
    if (isUndecidable(pictures, found, tolerance))
        diagnosis.verdict = DiagnosisVerdict::Undecidable;
    DefectSearch search(pictures, matcher, diagnosis, listener);
    if (!search.run())
        return std::nullopt;
    diagnosis.candidates = search.candidates();
    return diagnosis;
}

} // namespace pixelplumb
