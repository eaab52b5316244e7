// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"

#include "core/grade/picturediff.h"
#include "core/grade/undecidable.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

constexpr std::size_t nearestListed = 5;
constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

/// Pixels of all found pictures that differ, up to a limit; unknown where a scene cannot be drawn
/// so. Of those at a limit of 1 nobody asks but whether they are the same.
std::int64_t distanceOf(DefectPictures &pictures, std::span<const FoundPicture> found,
                        const DefectSet &set, std::int64_t limit)
{
    const bool isKnown = limit == 1 && std::ranges::any_of(found, [&](const FoundPicture &each) {
                             return pictures.isKnownToDiffer(each.scene, set, each.picture);
                         });
    if (isKnown)
        return limit;
    std::int64_t distance = 0;
    for (const FoundPicture &each : found) {
        if (distance >= limit)
            break;
        const auto picture = pictures.picture(each.scene, set);
        if (!picture)
            return unknown;
        distance += differingPixels(*picture, each.picture, limit - distance);
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

/// Whether what differs lies on ties and within the bound of float32 alone.
bool isUndecidable(DefectPictures &pictures, std::span<const FoundPicture> found)
{
    return std::ranges::all_of(found, [&](const FoundPicture &each) {
        const Picture &right = *pictures.picture(each.scene, {});
        return differenceOf(right, each.picture,
                            undecidablePixels(pictures.scenes()[each.scene], right, each.picture,
                                              Arithmetic::Float32))
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
    const Scene drawn = withDefects(scene, defects);
    const auto redrawing = std::ranges::find(defects, DefectStage::Drawing, &Defect::stage);
    Picture picture = redrawing == defects.end() ? pictureOf(drawn) : redrawing->redraw(drawn);
    for (const Defect &defect : defects) {
        if (defect.changePicture)
            picture = defect.changePicture(picture, scene.frame.background);
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
    std::vector<Scene> scenes;
    std::vector<FoundPicture> found;
    for (const Submission &submission : submissions) {
        found.push_back({scenes.size(), submission.picture});
        scenes.push_back(submission.scene);
    }
    DefectPictures pictures(std::move(scenes));
    return diagnose(pictures, found, listener);
}

std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener)
{
    Diagnosis diagnosis;
    diagnosis.differing = distanceOf(pictures, found, {}, unknown);
    if (diagnosis.differing == 0) {
        diagnosis.verdict = DiagnosisVerdict::Right;
        return diagnosis;
    }
    if (isUndecidable(pictures, found))
        diagnosis.verdict = DiagnosisVerdict::Undecidable;
    const std::vector<Defect> &defects = pictures.defects();
    const auto count = std::int64_t(defects.size());
    const std::int64_t sets = count * (count + 1) / 2; // at most
    std::int64_t tried = 0;
    CandidateList candidates;
    candidates.forgetFartherThan(diagnosis.differing); // what explains nothing is none
    std::vector<std::int64_t> alone;
    const auto goesOnTrying = [&] { return goesOn(listener, {JobPhase::Judging, ++tried, sets}); };
    // Once there is one that equals the pictures, only others that do are of interest.
    const auto distanceUpTo = [&](const DefectSet &set, std::int64_t limit) {
        return distanceOf(pictures, found, set, candidates.exact().empty() ? limit : 1);
    };
    for (std::size_t i = 0; i < defects.size(); ++i) {
        alone.push_back(distanceUpTo({i, {}}, diagnosis.differing));
        candidates.add({defects[i]}, alone.back());
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
            const std::int64_t least = std::min(alone[i], alone[j]);
            const std::int64_t distance = distanceUpTo({i, j}, least);
            if (distance < least)
                candidates.add({defects[i], defects[j]}, distance);
            if (!goesOnTrying())
                return std::nullopt;
        }
    }
    diagnosis.candidates = candidates.taken();
    return diagnosis;
}

} // namespace pixelplumb
