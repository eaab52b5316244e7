// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/diagnosis.h"

namespace pixelplumb {

/// Tries sets of one and of two defects.
class DefectSearch {
public:
    /// Sets that explain the pictures alone, of which few are tried; or what comes near, too.
    enum class Sought { Explanations, NearSets };

    /// The diagnosis says how many pixels differ, and whether they need an explanation: undecidable
    /// ones do not. Of lines, and where edges are open, only what is no mistake is then named.
    DefectSearch(DefectPictures &pictures, PictureMatcher &matcher, const Diagnosis &diagnosis,
                 const ProgressListener &listener, Sought sought = Sought::NearSets);

    /// False where the listener ended it.
    bool run() { return trySingles() && (m_areRight || tryPairs()); }

    std::vector<DiagnosisCandidate> candidates() const;

private:
    bool needsSecond(const SetMatch &near) const;
    std::int64_t rankOf(const SetMatch &near) const;
    DiagnosisCandidate candidateOf(const SetMatch &match) const;
    bool goesOnTrying() { return goesOn(m_listener, {JobPhase::Judging, ++m_tried, m_sets}); }
    std::int64_t distanceUpTo(const DefectSet &set, std::int64_t limit);
    std::int64_t limit() const;
    void addNear(const DefectSet &set, std::int64_t distance);
    bool addAllowed(const DefectSet &set);
    void explainNearest(bool pairs);
    void addEqual(DefectSet set);
    void tryArithmetics();
    void tryRules();
    bool trySingles();
    bool hasPart(const std::vector<SetMatch> &matches, std::size_t first, std::size_t second) const;
    bool canBePair(std::size_t first, std::size_t second) const;
    bool forPairs(const std::function<void(const DefectSet &pair)> &examine);
    std::int64_t leastAlone(const DefectSet &pair) const;
    bool tryPairs();
    void tryChoices();

    const std::vector<Defect> &m_defects;
    DefectPictures &m_pictures;
    PictureMatcher &m_matcher;
    const ProgressListener &m_listener;
    std::int64_t m_differing;
    bool m_isExplained; ///< by the right pictures up to open pixels, or by a set
    bool m_areRight; ///< all that differs is open, and no mistake is sought
    bool m_hasSingle = false; ///< one defect explains the pictures
    std::int64_t m_mostOpen; ///< pixels (PictureMatcher::mostOpen)
    std::int64_t m_mostNear; ///< pixels: sets that leave more are not sought
    std::size_t m_mostPaired; ///< single defects that are paired with another one
    std::int64_t m_sets = 0, m_tried = 0;
    std::vector<std::int64_t> m_alone; ///< distances, by defect
    std::vector<SetMatch> m_exact, m_open;
    std::vector<SetMatch> m_completed; ///< exact pairs; one defect alone leaves open pixels
    std::vector<SetMatch> m_nearest; ///< ascending
};

} // namespace pixelplumb
