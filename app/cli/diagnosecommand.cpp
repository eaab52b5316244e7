// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/diagnosisreport.h"
#include "app/cli/marginoptions.h"
#include "app/cli/picturefile.h"
#include "app/cli/progress.h"
#include "app/cli/sceneoptions.h"

namespace pixelplumb::cli {

namespace {

/// The picture of a file.
Result<Submission> readSubmission(const CommandLine &line, const QString &scenePath,
                                  const QString &picturePath)
{
    Result<Scene> scene = readScene(line, scenePath);
    if (!scene)
        return scene.error();
    if (const auto refusal = refusalToJudge(*scene, scenePath))
        return *refusal;
    Result<Picture> picture = readPicture(picturePath);
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
    line.addRepeatedOption(
        {sceneOption, QStringLiteral("A scene that was to be drawn; give one for each picture."),
         QStringLiteral("file")});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    addMarginOptions(line);
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const Result<Margin> margin = chosenMargin(line);
    if (!margin)
        return line.refuse(margin.error());
    const QStringList scenes = line.values(sceneOption);
    const QStringList pictures = line.arguments();
    if (scenes.size() != pictures.size())
        return line.refuse(QStringLiteral("--scene is given %1 times, PICTURE %2 times; expected "
                                          "--scene FILE once for each picture, in their order")
                               .arg(scenes.size())
                               .arg(pictures.size()));
    std::vector<Submission> submissions;
    for (qsizetype i = 0; i < scenes.size(); ++i) {
        Result<Submission> submission = readSubmission(line, scenes[i], pictures[i]);
        if (!submission)
            return line.refuse(submission.error());
        const FrameSpec &frame = submission->scene.frame;
        const Picture &picture = submission->picture;
        if (const auto refusal = refusalOfSizes({pictures[i], QSize(picture.width, picture.height)},
                                                {scenes[i], QSize(frame.width, frame.height)}))
            return *refusal;
        if (picture.isTransparent)
            sayLine(pictures[i] + QStringLiteral(": ") + transparencyText());
        submissions.push_back(std::move(*submission));
    }
    const auto diagnosis = withProgress([&](const ProgressListener &listener) {
        return pixelplumb::diagnose(submissions, listener, *margin);
    });
    if (line.isSet(jsonOption))
        printJson(QJsonDocument(jsonOf(*diagnosis, submissions)));
    else
        printLines(textOf(*diagnosis, submissions));
    return diagnosis->verdict == DiagnosisVerdict::Right ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
