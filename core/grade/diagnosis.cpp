// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"

#include "core/grade/defectsearch.h"
#include "core/grade/picturediff.h"
#include "core/grade/undecidable.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Of what differs, how many pixels lie on ties or within the bound of the tolerance.
std::int64_t undecidableIn(DefectPictures &pictures, std::span<const FoundPicture> found,
                           Arithmetic tolerance)
{
    std::int64_t undecidable = 0;
    for (const FoundPicture &each : found) {
        const Picture &right = *pictures.picture(each.scene, {});
        const auto open
            = undecidablePixels(pictures.scenes()[each.scene], right, each.picture, tolerance);
        undecidable += differenceOf(right, each.picture, open).count(PixelVerdict::Undecidable);
    }
    return undecidable;
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
    const bool isNoMistake = std::ranges::all_of(defects, &Defect::isRightAlone);
    for (const Defect &defect : defects) {
        const bool isTold = words != &Defect::forStudent || !defect.isRightAlone || isNoMistake;
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
    if (tolerance)
        diagnosis.undecidable = undecidableIn(pictures, found, *tolerance);
    if (diagnosis.undecidable == diagnosis.differing)
        diagnosis.verdict = DiagnosisVerdict::Undecidable;
    DefectSearch search(pictures, matcher, diagnosis, listener);
    if (!search.run())
        return std::nullopt;
    diagnosis.candidates = search.candidates();
    return diagnosis;
}

} // namespace pixelplumb
