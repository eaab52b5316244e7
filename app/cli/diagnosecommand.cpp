// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/number/failure.h"
#include "core/scan/choicenames.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

constexpr std::size_t mostTold = 5; // candidates, in sentences

struct PartingPlace {
    std::size_t scene = 0; ///< of those given, from 1
    PartingStep step;
};

/// The first step of the first scene at which a candidate's run departs from the right one; none
/// where an error makes the runs impossible to compare.
std::optional<PartingPlace> partingPlaceOf(std::span<const Submission> submissions,
                                           const DiagnosisCandidate &candidate)
{
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const Scene &scene = submissions[i].scene;
        const auto own = ownDefects(defectsFor(scene), candidate.defects);
        std::optional<PartingStep> step;
        failureOf([&] { step = partingStepOf(scene, own); });
        if (step)
            return PartingPlace{i + 1, *std::move(step)};
    }
    return std::nullopt;
}

/// "unsorted-colours, but for 3 pixels that …", "flat-first (1 pixel is left)"
QString titleOf(const DiagnosisCandidate &candidate)
{
    QString title = candidate.ids().join(u" and "_s);
    if (candidate.undecidable > 0)
        title += u", "_s + undecidableText(candidate.undecidable);
    if (candidate.distance > 0)
        title += u" (%1 %2 left)"_s.arg(pixelsText(candidate.distance),
                                        candidate.distance == 1 ? u"is"_s : u"are"_s);
    return title;
}

/// How many of the candidates, the first ones, draw the very pictures found. One of them is told
/// whole, the others by their names alone: nothing in the pictures speaks for any rather than
/// another.
std::size_t synonymsIn(const Diagnosis &diagnosis)
{
    const auto isEqual = [](const DiagnosisCandidate &candidate) {
        return candidate.distance == 0 && candidate.undecidable == 0;
    };
    const auto &all = diagnosis.candidates;
    return std::size_t(std::ranges::find_if_not(all, isEqual) - all.begin());
}

/// Where wrong pixels lie; of several pictures with the scene's number.
QStringList placeLines(const Diagnosis &diagnosis)
{
    QStringList lines;
    for (std::size_t i = 0; i < diagnosis.places.size(); ++i) {
        const QString scene = diagnosis.places.size() > 1 ? u"scene %1, "_s.arg(i + 1) : QString();
        for (const QString &place : diagnosis.places[i])
            lines += u"    "_s + scene + place;
    }
    return lines;
}

/// "the same pictures also come from slack-of-one; slack-of-half"
QString synonymsText(std::span<const DiagnosisCandidate> others)
{
    QStringList names;
    for (const DiagnosisCandidate &candidate : others)
        names += candidate.ids().join(u" and "_s);
    return u"    the same pictures also come from "_s + names.join(u"; "_s);
}

} // namespace

QStringList diagnosisLines(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return {u"right: no pixel differs"_s};
    const bool isWrong = diagnosis.verdict == DiagnosisVerdict::Wrong;
    QString verdict = u"%1: %2 %3"_s.arg(nameOf(diagnosis.verdict), pixelsText(diagnosis.differing),
                                         diagnosis.differing == 1 ? u"differs"_s : u"differ"_s);
    if (isWrong && diagnosis.undecidable > 0)
        verdict += u", %1 of them undecidable"_s.arg(diagnosis.undecidable);
    QStringList lines = {verdict};
    if (diagnosis.failure)
        lines += u"the search for defects ended in an error: %1"_s.arg(*diagnosis.failure);
    else if (!diagnosis.isExplained() && isWrong)
        lines += QStringList(u"no known defect explains it"_s) + placeLines(diagnosis);
    if (!diagnosis.candidates.empty() && !diagnosis.isExplained() && isWrong)
        lines += u"the nearest ones:"_s;
    if (diagnosis.sampled && isWrong)
        lines += u"    "_s + sampledText(*diagnosis.sampled);
    const std::size_t synonyms = synonymsIn(diagnosis);
    for (std::size_t i = 0; i < diagnosis.candidates.size(); ++i) {
        const DiagnosisCandidate &candidate = diagnosis.candidates[i];
        if (i > 0 && i < synonyms)
            continue;
        lines += titleOf(candidate);
        // Of many that are open the first are told, the others named.
        const bool isTold = isRelevant(candidate.distance, diagnosis.differing)
            && std::max(i, synonyms) - synonyms < mostTold;
        if (!isTold)
            continue;
        for (const QString &sentence : candidate.sentences(&Defect::forAssistant))
            lines += u"    "_s + sentence;
        for (const QString &sentence : candidate.sentences(&Defect::forStudent))
            lines += u"    to the student: "_s + sentence;
        if (const auto place = partingPlaceOf(submissions, candidate)) {
            const QString where
                = submissions.size() > 1 ? u"scene %1, "_s.arg(place->scene) : QString();
            lines += u"    departs from the right run at %1step %2, %3: %4"_s.arg(
                where, QString::number(place->step.step + 1), place->step.heading,
                place->step.text);
        }
        if (i == 0 && synonyms > 1)
            lines += synonymsText(std::span(diagnosis.candidates).subspan(1, synonyms - 1));
    }
    return lines;
}

QJsonObject diagnosisJson(const Diagnosis &diagnosis, std::span<const Submission> submissions)
{
    QJsonArray candidates;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        const auto array = &QJsonArray::fromStringList;
        QJsonObject object{{u"defects"_s, array(candidate.ids())},
                           {u"distance"_s, qint64(candidate.distance)},
                           {u"undecidable"_s, qint64(candidate.undecidable)},
                           {u"student"_s, array(candidate.sentences(&Defect::forStudent))},
                           {u"assistant"_s, array(candidate.sentences(&Defect::forAssistant))}};
        if (candidate.arithmetic)
            object.insert(u"arithmetic"_s, nameText(nameOf(*candidate.arithmetic)));
        if (const auto place = partingPlaceOf(submissions, candidate))
            object.insert(u"parts"_s,
                          QJsonObject{{u"scene"_s, qint64(place->scene)},
                                      {u"step"_s, qint64(place->step.step + 1)},
                                      {u"at"_s, place->step.heading},
                                      {u"how"_s, place->step.text}});
        candidates.append(object);
    }
    const bool isTransparent = std::ranges::any_of(
        submissions, [](const Submission &submission) { return submission.picture.isTransparent; });
    QJsonObject object{{u"verdict"_s, nameOf(diagnosis.verdict)},
                       {u"transparencyIgnored"_s, isTransparent},
                       {u"differing"_s, qint64(diagnosis.differing)},
                       {u"undecidable"_s, qint64(diagnosis.undecidable)},
                       {u"candidates"_s, candidates},
                       {u"picturesDrawn"_s, qint64(diagnosis.work.pictures)},
                       {u"pixelsDrawn"_s, qint64(diagnosis.work.pixels)}};
    if (diagnosis.sampled)
        object.insert(u"sampled"_s,
                      QJsonObject{{u"spans"_s, qint64(diagnosis.sampled->spans)},
                                  {u"of"_s, qint64(diagnosis.sampled->of)}});
    if (diagnosis.failure)
        object.insert(u"searchError"_s, *diagnosis.failure);
    return object;
}

namespace {

/// The picture of a file.
Submission readSubmission(const CommandLine &line, const QString &scenePath,
                          const QString &picturePath)
{
    Scene scene = readScene(line, scenePath).scene;
    refuseToJudgeBy(scene, scenePath);
    Picture picture = readPicture(picturePath);
    if (picture.hasColours)
        coverAllBut(scene.frame.background, picture);
    return Submission{std::move(scene), std::move(picture)};
}

} // namespace

ExitCode diagnose(const Command &command, const QStringList &arguments)
{
    const QString sceneOption = u"scene"_s;
    CommandLine line(
        command,
        {{u"PICTURE"_s,
          u"what a program drew of each scene, in their order: PNG, PPM, BMP or a raster of # and "
          "."_s,
          Positional::Presence::Several}});
    line.addRepeatedOption(
        {sceneOption, u"A scene that was to be drawn; give one for each picture."_s, u"file"_s});
    line.addJsonOption();
    addMarginOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const Margin margin = chosenMargin(line);
    const QStringList scenes = line.values(sceneOption);
    const QStringList pictures = line.arguments();
    if (scenes.size() != pictures.size())
        refuse(u"--scene is given %1 times, PICTURE %2 times; expected --scene FILE once for each "
               "picture, in their order"_s.arg(scenes.size())
                   .arg(pictures.size()));
    std::vector<Submission> submissions;
    for (qsizetype i = 0; i < scenes.size(); ++i) {
        Submission submission = readSubmission(line, scenes[i], pictures[i]);
        submission.scene = judgedScene(submission.scene, margin);
        const FrameSpec &frame = submission.scene.frame;
        const Picture &picture = submission.picture;
        refuseOtherSizes({pictures[i], QSize(picture.width, picture.height)},
                         {scenes[i], QSize(frame.width, frame.height)});
        if (picture.isTransparent)
            sayLine(pictures[i] + u": "_s + transparencyText());
        submissions.push_back(std::move(submission));
    }
    const auto diagnosis = withProgress([&](const ProgressListener &listener) {
        return pixelplumb::diagnose(submissions, listener, margin);
    });
    line.asksForJson() ? printJson(diagnosisJson(*diagnosis, submissions))
                       : printLines(diagnosisLines(*diagnosis, submissions));
    return diagnosis->verdict == DiagnosisVerdict::Right ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
