// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/progress.h"
#include "app/cli/sceneoptions.h"
#include "core/grade/diagnosis.h"

#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

/// The first step of the first scene at which a candidate's run parts from the right one.
std::optional<PartingStep> partingStepOf(const std::vector<Submission> &submissions,
                                         const DiagnosisCandidate &candidate)
{
    for (const Submission &submission : submissions) {
        const Scene defective = withDefects(submission.scene, candidate.defects);
        if (defective == submission.scene)
            continue;
        if (auto step = pixelplumb::partingStepOf(submission.scene, defective))
            return step;
    }
    return std::nullopt;
}

/// "3 pixels differ"; one differs.
QString countText(std::int64_t pixels, const QString &verb)
{
    return pixels == 1 ? QStringLiteral("1 pixel %1s").arg(verb)
                       : QStringLiteral("%1 pixels %2").arg(pixels).arg(verb);
}

QStringList diagnosisLines(const Diagnosis &diagnosis, const std::vector<Submission> &submissions)
{
    if (diagnosis.verdict == DiagnosisVerdict::Right)
        return {QStringLiteral("right: no pixel differs")};
    QStringList lines = {QStringLiteral("%1: %2").arg(
        nameOf(diagnosis.verdict), countText(diagnosis.differing, QStringLiteral("differ")))};
    if (diagnosis.candidates.empty())
        lines += QStringLiteral("no known defect comes nearer");
    else if (!diagnosis.isExplained())
        lines += QStringLiteral("no known defect explains it; the nearest ones:");
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QStringList ids;
        for (const Defect &defect : candidate.defects)
            ids += defect.id;
        lines += diagnosis.isExplained() ? ids.join(QStringLiteral(" and "))
                                         : QStringLiteral("%1 (%2 pixels are left)")
                                               .arg(ids.join(QStringLiteral(" and ")))
                                               .arg(candidate.distance);
        for (const Defect &defect : candidate.defects) {
            lines += QStringLiteral("    ") + defect.forAssistant;
            lines += QStringLiteral("    to the student: ") + defect.forStudent;
        }
        if (const auto step = partingStepOf(submissions, candidate))
            lines += QStringLiteral("    parts at step %1, %2: %3")
                         .arg(step->step + 1)
                         .arg(step->heading, step->text);
    }
    return lines;
}

QJsonObject jsonOf(const Diagnosis &diagnosis, const std::vector<Submission> &submissions)
{
    QJsonArray candidates;
    for (const DiagnosisCandidate &candidate : diagnosis.candidates) {
        QJsonArray ids;
        QJsonArray forStudent;
        QJsonArray forAssistant;
        for (const Defect &defect : candidate.defects) {
            ids.append(defect.id);
            forStudent.append(defect.forStudent);
            forAssistant.append(defect.forAssistant);
        }
        QJsonObject object{{QStringLiteral("defects"), ids},
                           {QStringLiteral("distance"), qint64(candidate.distance)},
                           {QStringLiteral("student"), forStudent},
                           {QStringLiteral("assistant"), forAssistant}};
        if (const auto step = partingStepOf(submissions, candidate))
            object.insert(QStringLiteral("parts"),
                          QJsonObject{{QStringLiteral("step"), qint64(step->step + 1)},
                                      {QStringLiteral("at"), step->heading},
                                      {QStringLiteral("how"), step->text}});
        candidates.append(object);
    }
    return {{QStringLiteral("verdict"), nameOf(diagnosis.verdict)},
            {QStringLiteral("differing"), qint64(diagnosis.differing)},
            {QStringLiteral("candidates"), candidates}};
}

/// The picture of a file.
Result<Submission> readSubmission(const CommandLine &line, const QString &scenePath,
                                  const QString &picturePath)
{
    Result<Scene> scene = readScene(line, scenePath);
    if (!scene)
        return scene.error();
    const Result<QByteArray> content = readInput(picturePath);
    if (!content)
        return content.error();
    Result<Picture> picture = parsePicture(*content, picturePath);
    if (!picture)
        return picture.error();
    if (picture->hasColours)
        coverAllBut(scene->frame.background, *picture);
    return Submission{std::move(*scene), std::move(*picture)};
}

} // namespace

ExitCode diagnose(const Command &command, const QStringList &arguments)
{
    const QString sceneOption = QStringLiteral("scene");
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(command,
                     {{QStringLiteral("PICTURE"),
                       QStringLiteral("what a program drew of each scene, in their order: PNG, "
                                      "PPM, BMP or a raster of # and ."),
                       Positional::Presence::Several}});
    line.addOption({sceneOption, QStringLiteral("A scene that was to be drawn; once a picture."),
                    QStringLiteral("file")});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const QStringList scenes = line.values(sceneOption);
    const QStringList pictures = line.arguments();
    if (scenes.size() != pictures.size())
        return line.refuse(QStringLiteral("%1 scenes and %2 pictures; expected --scene FILE once "
                                          "for each picture, in their order")
                               .arg(scenes.size())
                               .arg(pictures.size()));
    std::vector<Submission> submissions;
    for (qsizetype i = 0; i < scenes.size(); ++i) {
        Result<Submission> submission = readSubmission(line, scenes[i], pictures[i]);
        if (!submission)
            return line.refuse(submission.error());
        const FrameSpec &frame = submission->scene.frame;
        const Picture &picture = submission->picture;
        if (picture.width != frame.width || picture.height != frame.height) {
            sayLine(QStringLiteral("%1 has %2 × %3 pixels, %4 has %5 × %6")
                        .arg(pictures[i])
                        .arg(picture.width)
                        .arg(picture.height)
                        .arg(scenes[i])
                        .arg(frame.width)
                        .arg(frame.height));
            return ExitCode::SizesDiffer;
        }
        submissions.push_back(std::move(*submission));
    }
    Progress progress;
    const auto diagnosis = pixelplumb::diagnose(submissions, progress.listener());
    if (line.isSet(jsonOption))
        printJson(QJsonDocument(jsonOf(*diagnosis, submissions)));
    else
        printLines(diagnosisLines(*diagnosis, submissions));
    return diagnosis->verdict == DiagnosisVerdict::Right ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
