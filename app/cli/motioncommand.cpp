// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/options.h"
#include "core/compare/motionstudy.h"

#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

QStringList motionLines(const MotionStudy &study)
{
    std::vector<QStringList> rows
        = {{QStringLiteral("frame"), QStringLiteral("pixels"), QStringLiteral("truth"),
            QStringLiteral("toggled"), QStringLiteral("truth")}};
    for (std::size_t i = 0; i < study.frames.size(); ++i) {
        const MotionFrame &frame = study.frames[i];
        rows.push_back({QString::number(i), QString::number(frame.drawn),
                        QString::number(frame.truth), QString::number(frame.toggled),
                        QString::number(frame.truthToggled)});
    }
    return alignedRows(rows, [](qsizetype) { return false; })
        + QStringList{QStringLiteral("toggled in all: %1 (truth %2)")
                          .arg(study.toggled())
                          .arg(study.truthToggled())};
}

QJsonObject jsonOf(const MotionStudy &study)
{
    QJsonArray frames;
    for (const MotionFrame &frame : study.frames)
        frames.append(QJsonObject{{QStringLiteral("pixels"), qint64(frame.drawn)},
                                  {QStringLiteral("truth"), qint64(frame.truth)},
                                  {QStringLiteral("toggled"), qint64(frame.toggled)},
                                  {QStringLiteral("truthToggled"), qint64(frame.truthToggled)}});
    return {{QStringLiteral("frames"), frames},
            {QStringLiteral("toggled"), qint64(study.toggled())},
            {QStringLiteral("truthToggled"), qint64(study.truthToggled())}};
}

} // namespace

ExitCode motion(const Command &command, const QStringList &arguments)
{
    CommandLine line(command, {scenePositional()});
    line.addJsonOption();
    addSettingOptions(line);
    line.parse(arguments);
    if (line.isSet(QStringLiteral("frame")))
        refuse(InputError{QStringLiteral("--frame"),
                          QStringLiteral("motion counts in all frames of the scene"),
                          QStringLiteral("it without --frame; one frame is drawn by "
                                         "“render --frame”")});
    const Scene scene = readScene(line, line.argument(0)).scene;
    if (!scene.motion)
        refuse(InputError{
            line.argument(0), QStringLiteral("the scene does not move"),
            QStringLiteral("a scene with \"motion\": { \"by\": [x, y], \"frames\": n }")});
    const auto study = withProgress(
        [&](const ProgressListener &listener) { return studyMotion(scene, listener); });
    line.asksForJson() ? printJson(jsonOf(*study)) : printLines(motionLines(*study));
    return study->toggled() != study->truthToggled() ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
