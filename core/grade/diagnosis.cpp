// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"

#include "core/grade/picturediff.h"
#include "core/runs/sceneplan.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

constexpr std::size_t nearestListed = 5;
constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

/// Pixels that differ, up to a limit at which nobody cares.
std::int64_t distanceOf(const Picture &a, const Picture &b, std::int64_t limit)
{
    const bool byColour = a.hasColours && b.hasColours;
    std::int64_t distance = 0;
    for (std::size_t i = 0; i < a.size() && distance < limit; ++i)
        distance += int(byColour ? a.colours[i] != b.colours[i] : a.covered[i] != b.covered[i]);
    return distance;
}

/// The sum over all submissions; unknown where a scene cannot be drawn so.
std::int64_t distanceOf(std::span<const Submission> submissions, std::span<const Defect> defects,
                        std::int64_t limit)
{
    std::int64_t distance = 0;
    for (const Submission &submission : submissions) {
        if (!objectionTo(withDefects(submission.scene, defects)).isEmpty())
            return unknown;
        distance += distanceOf(pictureWith(submission.scene, defects), submission.picture,
                               limit - distance);
        if (distance >= limit)
            return distance;
    }
    return distance;
}

bool hasPart(const std::vector<DiagnosisCandidate> &exact, const Defect &first,
             const Defect &second)
{
    return std::ranges::any_of(exact, [&](const DiagnosisCandidate &candidate) {
        return candidate.defects.size() == 1
            && (candidate.defects.front().id == first.id
                || candidate.defects.front().id == second.id);
    });
}

/// Those that some scene can have: a defect that leaves one scene as it is may change another.
std::vector<Defect> defectsOf(std::span<const Submission> submissions)
{
    std::vector<Defect> all;
    for (const Submission &submission : submissions) {
        for (Defect &defect : defectsFor(submission.scene)) {
            const bool isKnown = std::ranges::find(all, defect.id, &Defect::id) != all.end();
            if (!isKnown)
                all.push_back(std::move(defect));
        }
    }
    // What is done to a picture is done after the scene is drawn: it comes second in a pair.
    std::stable_partition(all.begin(), all.end(),
                          [](const Defect &each) { return !each.isOfPicture(); });
    return all;
}

/// Keeps what equals the pictures, and beside that what comes nearest.
class CandidateList {
public:
    void add(std::vector<Defect> defects, std::int64_t distance)
    {
        if (distance == 0) {
            m_exact.push_back({std::move(defects), 0});
            return;
        }
        if (distance == unknown || distance >= limit())
            return;
        const auto place
            = std::ranges::upper_bound(m_nearest, distance, {}, &DiagnosisCandidate::distance);
        m_nearest.insert(place, {std::move(defects), distance});
        if (m_nearest.size() > nearestListed)
            m_nearest.pop_back();
    }
    /// From here on a distance is of no interest.
    std::int64_t limit() const
    {
        return m_nearest.size() < nearestListed ? m_farthest : m_nearest.back().distance;
    }
    void forgetFartherThan(std::int64_t distance) { m_farthest = distance; }

    const std::vector<DiagnosisCandidate> &exact() const { return m_exact; }
    std::vector<DiagnosisCandidate> taken() { return m_exact.empty() ? m_nearest : m_exact; }

private:
    std::vector<DiagnosisCandidate> m_exact, m_nearest;
    std::int64_t m_farthest = unknown - 1;
};

/// Whether what differs lies on ties alone.
bool isUndecidable(std::span<const Submission> submissions)
{
    return std::ranges::all_of(submissions, [](const Submission &submission) {
        return differenceOf(pictureOf(submission.scene), submission.picture,
                            tiesOf(submission.scene))
                   .differing()
            == 0;
    });
}

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

Picture pictureWith(const Scene &scene, std::span<const Defect> defects)
{
    Picture picture = pictureOf(withDefects(scene, defects));
    for (const Defect &defect : defects) {
        if (defect.isOfPicture())
            picture = defect.changePicture(picture);
    }
    return picture;
}

Scene withDefects(Scene scene, std::span<const Defect> defects)
{
    for (const Defect &defect : defects) {
        if (defect.changeScene)
            defect.changeScene(scene);
    }
    return scene;
}

std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener)
{
    Diagnosis diagnosis;
    diagnosis.differing = distanceOf(submissions, {}, unknown);
    if (diagnosis.differing == 0) {
        diagnosis.verdict = DiagnosisVerdict::Right;
        return diagnosis;
    }
    if (isUndecidable(submissions))
        diagnosis.verdict = DiagnosisVerdict::Undecidable;
    const std::vector<Defect> defects = defectsOf(submissions);
    const auto count = std::int64_t(defects.size());
    const std::int64_t sets = count * (count + 1) / 2; // at most
    std::int64_t tried = 0;
    CandidateList candidates;
    candidates.forgetFartherThan(diagnosis.differing); // what explains nothing is none
    std::vector<std::int64_t> alone;
    const auto goesOnTrying = [&] { return goesOn(listener, {JobPhase::Judging, ++tried, sets}); };
    for (const Defect &defect : defects) {
        alone.push_back(distanceOf(submissions, std::span(&defect, 1), diagnosis.differing));
        candidates.add({defect}, alone.back());
        if (!goesOnTrying())
            return std::nullopt;
    }
    for (std::size_t i = 0; i < defects.size(); ++i) {
        for (std::size_t j = i + 1; j < defects.size(); ++j) {
            const bool isOneChoice
                = !defects[i].choice.isEmpty() && defects[i].choice == defects[j].choice;
            if (isOneChoice || defects[i].standsAlone || defects[j].standsAlone
                || hasPart(candidates.exact(), defects[i], defects[j]))
                continue;
            // A pair is one where each of the two is needed.
            const std::vector<Defect> pair = {defects[i], defects[j]};
            const std::int64_t distance
                = distanceOf(submissions, pair, std::min(alone[i], alone[j]));
            if (distance < std::min(alone[i], alone[j]))
                candidates.add(pair, distance);
            if (!goesOnTrying())
                return std::nullopt;
        }
    }
    diagnosis.candidates = candidates.taken();
    return diagnosis;
}

} // namespace pixelplumb
