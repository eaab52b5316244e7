// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"

#include "core/grade/defectsearch.h"
#include "core/grade/picturediff.h"
#include "core/grade/undecidable.h"

#include <algorithm>

namespace pixelplumb {

namespace {

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

/// Whether two together leave clearly less than the better of them alone: three quarters at most.
constexpr bool isClearGain(std::int64_t together, std::int64_t alone)
{
    return together <= alone - alone / 4;
}

/// The one of a pair that comes nearest by itself.
DiagnosisCandidate betterOf(const DiagnosisCandidate &pair, const DefectPictures &pictures,
                            PictureMatcher &matcher)
{
    DiagnosisCandidate better;
    better.distance = PictureMatcher::unknown;
    for (const Defect &defect : pair.defects) {
        const auto place = std::ranges::find(pictures.defects(), defect.id, &Defect::id);
        if (place == pictures.defects().end())
            continue;
        const auto index = std::size_t(place - pictures.defects().begin());
        if (const std::int64_t distance = matcher.distance({index}); distance < better.distance)
            better = {{defect}, distance};
    }
    return better;
}

/// Of sets that come near, one alone where a second hardly brings it nearer: nobody should look for
/// a mistake that is not there.
std::vector<DiagnosisCandidate> withClearPairs(std::vector<DiagnosisCandidate> candidates,
                                               const DefectPictures &pictures,
                                               PictureMatcher &matcher)
{
    std::vector<DiagnosisCandidate> clear;
    for (DiagnosisCandidate &each : candidates) {
        if (each.distance > 0 && each.defects.size() == 2) {
            DiagnosisCandidate better = betterOf(each, pictures, matcher);
            if (!isClearGain(each.distance, better.distance))
                each = std::move(better);
        }
        if (std::ranges::find(clear, each.ids(), &DiagnosisCandidate::ids) == clear.end())
            clear.push_back(std::move(each));
    }
    std::ranges::stable_sort(clear, {}, &DiagnosisCandidate::distance);
    return clear;
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

QStringList DiagnosisCandidate::ids() const
{
    QStringList ids;
    for (const Defect &defect : defects)
        ids += defect.id;
    return ids;
}

QStringList DiagnosisCandidate::rightAlone() const
{
    QStringList ids;
    for (const Defect &defect : defects) {
        if (defect.isRightAlone)
            ids += defect.id;
    }
    return ids;
}

QStringList DiagnosisCandidate::sentences(QString Defect::*words) const
{
    QStringList sentences;
    for (const Defect &defect : defects) {
        const bool isTold = words != &Defect::forStudent || !defect.isRightAlone;
        if (isTold && !sentences.contains(defect.*words))
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
    if (!diagnosis.isExplained())
        diagnosis.candidates = withClearPairs(std::move(diagnosis.candidates), pictures, matcher);
    return diagnosis;
}

} // namespace pixelplumb
