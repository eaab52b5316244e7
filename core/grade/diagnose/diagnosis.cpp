// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"

#include "core/grade/diagnose/defectsearch.h"
#include "core/grade/diagnose/readconvention.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturecause.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/pictures/wrongplaces.h"
#include "core/number/failure.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// How many of the differing pixels lie on ties or within the margin, and where the others are.
void judge(DefectPictures &pictures, std::span<const FoundPicture> found, const Margin &margin,
           Diagnosis &diagnosis)
{
    for (const FoundPicture &each : found) {
        const Scene &scene = pictures.scenes()[each.scene];
        const Picture &right = *pictures.picture(each.scene, {});
        const auto open = undecidablePixels(scene, right, each.picture, margin);
        const PictureDiff diff = differenceOf(right, each.picture, open);
        diagnosis.undecidable += diff.count(Difference::Undecidable);
        diagnosis.places.push_back(wrongPlaces(diff, right, scene.frame));
    }
}

/// False where the listener ended it.
bool diagnoseOnItsBackground(DefectPictures &pictures, std::span<const FoundPicture> found,
                             const ProgressListener &listener, const Margin &margin,
                             Diagnosis &diagnosis)
{
    PictureMatcher matcher(pictures, found, margin);
    diagnosis.differing = matcher.distance({});
    if (diagnosis.differing == 0) {
        diagnosis.verdict = DiagnosisVerdict::Right;
        return true;
    }
    judge(pictures, found, margin, diagnosis);
    if (diagnosis.undecidable == diagnosis.differing)
        diagnosis.verdict = DiagnosisVerdict::Undecidable;
    DefectSearch search(pictures, matcher, diagnosis, listener);
    if (!search.run())
        return false;
    diagnosis.candidates = search.candidates();
    if (!diagnosis.isExplained())
        diagnosis.sampled = matcher.sampledPart();
    return true;
}

/// The other background, if all pictures share one.
std::optional<Colour> otherBackgroundOf(DefectPictures &pictures,
                                        std::span<const FoundPicture> found)
{
    std::optional<Colour> other;
    for (const FoundPicture &each : found) {
        const Colour &background = pictures.scenes()[each.scene].frame.background;
        const auto own
            = otherBackgroundIn(each.picture, *pictures.picture(each.scene, {}), background);
        if (!own || (other && *own != *other))
            return std::nullopt;
        other = own;
    }
    return other;
}

/// Where no defect is named beside what was read off the pictures, but that alone leaves little, an
/// empty set says what it leaves.
void addRest(Diagnosis &beside, const Diagnosis &asAsked)
{
    const std::int64_t left = beside.differing - beside.undecidable;
    if (beside.candidates.empty() && isRelevant(left, asAsked.differing))
        beside.candidates.push_back({{}, left, beside.undecidable});
}

/// Replaces the other background by the scenes' own, except where its colour is rightly drawn.
std::vector<FoundPicture> onRightBackground(DefectPictures &pictures,
                                            std::span<const FoundPicture> found,
                                            const Colour &other)
{
    std::vector<FoundPicture> changed(found.begin(), found.end());
    for (FoundPicture &each : changed) {
        const auto right = pictures.picture(each.scene, {});
        const Colour &background = pictures.scenes()[each.scene].frame.background;
        for (std::size_t place = 0; place < right->size(); ++place) {
            const bool isDrawn = right->covered[place] != 0 && right->colours[place] == other;
            if (isDrawn || each.picture.colours[place] != other)
                continue;
            each.picture.colours[place] = background;
            each.picture.covered[place] = 0;
        }
    }
    return changed;
}

/// "black or (64, 64, 64)", if scenes differ.
QString backgroundsOf(const DefectPictures &pictures, std::span<const FoundPicture> found)
{
    QStringList names;
    for (const FoundPicture &each : found)
        names += nameOf(pictures.scenes()[each.scene].frame.background);
    names.removeDuplicates();
    return names.join(u" or "_s);
}

Defect drawnOnOther(const Colour &other, const QString &backgrounds)
{
    const PictureChange change = drawnOn(other, backgrounds);
    const auto &[red, green, blue] = other.channels;
    return {.id = u"drawn-on-%1-%2-%3"_s.arg(red).arg(green).arg(blue),
            .forStudent = u"What is in the frame before anything is drawn?"_s,
            .forAssistant = u"Done to the whole picture: %1."_s.arg(change.name),
            .changePicture = change.pixel,
            .choice = change.kind};
}

/// False where the listener ended it.
bool diagnoseOnAnyBackground(DefectPictures &pictures, std::span<const FoundPicture> found,
                             const ProgressListener &listener, const Margin &margin,
                             Diagnosis &diagnosis)
{
    if (!diagnoseOnItsBackground(pictures, found, listener, margin, diagnosis))
        return false;
    const bool isUnexplained
        = diagnosis.verdict == DiagnosisVerdict::Wrong && !diagnosis.isExplained();
    const auto other = isUnexplained ? otherBackgroundOf(pictures, found) : std::nullopt;
    if (!other)
        return true;
    Diagnosis beside;
    if (!diagnoseOnItsBackground(pictures, onRightBackground(pictures, found, *other), listener,
                                 margin, beside))
        return false;
    addRest(beside, diagnosis);
    if (beside.candidates.empty())
        return true;
    const Defect drawnOnIt = drawnOnOther(*other, backgroundsOf(pictures, found));
    for (DiagnosisCandidate &candidate : beside.candidates)
        candidate.defects.push_back(drawnOnIt);
    diagnosis.candidates = std::move(beside.candidates);
    diagnosis.sampled = beside.sampled;
    return true;
}

/// Whether a defect undoes one of the conventions that were read, such as the rule.
bool undoes(const DiagnosisCandidate &candidate, const std::vector<Defect> &read)
{
    return std::ranges::any_of(candidate.defects, [&](const Defect &defect) {
        return !defect.choice.isEmpty()
            && std::ranges::find(read, defect.choice, &Defect::choice) != read.end();
    });
}

/// Whether whole pictures are upside down or half a pixel off, which a convention may be.
bool isTurnedOrMoved(const Diagnosis &diagnosis)
{
    return std::ranges::any_of(diagnosis.candidates.front().defects, [](const Defect &defect) {
        return defect.id == u"upside-down"_s || defect.choice == u"centre"_s;
    });
}

/// Where nothing explains the pictures as the scenes ask for them, or what would also be a
/// convention, they are judged by the conventions that are read off them, which are told first.
/// False where the listener ended it.
bool diagnoseUnderAnyConvention(DefectPictures &pictures, std::span<const FoundPicture> found,
                                const ProgressListener &listener, const Margin &margin,
                                Diagnosis &diagnosis)
{
    if (!diagnoseOnAnyBackground(pictures, found, listener, margin, diagnosis))
        return false;
    const bool isWrong = diagnosis.verdict == DiagnosisVerdict::Wrong;
    const bool isExplained = diagnosis.isExplained();
    const bool isSought = isWrong && (!isExplained || isTurnedOrMoved(diagnosis));
    auto read = isSought ? readConvention(pictures, found) : std::nullopt;
    if (!read)
        return true;
    DefectPictures readPictures(std::move(read->scenes));
    Diagnosis beside;
    if (!diagnoseOnItsBackground(readPictures, found, listener, margin, beside))
        return false;
    if (isExplained && beside.verdict == DiagnosisVerdict::Wrong)
        return true; // a convention is told in place of mistakes only where it is all
    diagnosis.work = readPictures.work();
    std::erase_if(beside.candidates, [&](const DiagnosisCandidate &candidate) {
        return undoes(candidate, read->told);
    });
    addRest(beside, diagnosis);
    if (beside.candidates.empty())
        return true;
    for (DiagnosisCandidate &candidate : beside.candidates) {
        const bool isRight = candidate.defects.empty() && candidate.distance == 0;
        candidate.defects.insert(candidate.defects.begin(), read->told.begin(), read->told.end());
        if (isRight)
            candidate.defects.back().forAssistant += read->told.size() == 1
                ? u" The pictures are right under that convention."_s
                : u" The pictures are right under these conventions."_s;
    }
    diagnosis.candidates = std::move(beside.candidates);
    diagnosis.sampled = beside.sampled;
    return true;
}

} // namespace

QString nameOf(DiagnosisVerdict verdict)
{
    switch (verdict) {
    case DiagnosisVerdict::Right:
        return u"right"_s;
    case DiagnosisVerdict::Undecidable:
        return u"undecidable"_s;
    case DiagnosisVerdict::Wrong:
        break;
    }
    return u"wrong"_s;
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
    return pixels == 1 ? u"1 pixel"_s : u"%1 pixels"_s.arg(pixels);
}

QString undecidableText(std::int64_t pixels)
{
    return pixels == 0
        ? QString()
        : u"but for %1 that rounding or a sample on an edge may decide"_s.arg(pixelsText(pixels));
}

QString sampledText(const SampledPart &part)
{
    return u"sets that only come near were looked for in %1 of %2 columns or rows: a nearer one "
           u"may "
           "be missing"_s.arg(part.spans)
               .arg(part.of);
}

std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener, const Margin &margin)
{
    std::vector<Scene> scenes;
    std::vector<FoundPicture> found;
    for (const Submission &submission : submissions) {
        found.push_back({scenes.size(), submission.picture});
        scenes.push_back(submission.scene);
    }
    DefectPictures pictures(std::move(scenes));
    auto diagnosis = diagnose(pictures, found, listener, margin);
    const bool isUnexplained = diagnosis && !diagnosis->failure && !diagnosis->isExplained()
        && diagnosis->verdict == DiagnosisVerdict::Wrong;
    if (!isUnexplained)
        return diagnosis;
    auto others = setsOfOtherMethods(pictures, found, listener, margin);
    if (!others)
        return std::nullopt;
    if (!others->empty()) {
        diagnosis->candidates = *std::move(others);
        diagnosis->sampled.reset();
    }
    return diagnosis;
}

std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener, const Margin &margin)
{
    Diagnosis diagnosis;
    const DrawnWork before = pictures.work();
    bool isDone = true;
    diagnosis.failure = failureOf(
        [&] { isDone = diagnoseUnderAnyConvention(pictures, found, listener, margin, diagnosis); });
    diagnosis.work = diagnosis.work + (pictures.work() - before);
    return isDone ? std::optional(std::move(diagnosis)) : std::nullopt;
}

} // namespace pixelplumb
