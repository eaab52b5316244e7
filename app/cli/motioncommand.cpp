// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/compare/motionstudy.h"

#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

QStringList motionLines(const MotionStudy &study)
{
    std::vector<QStringList> rows
        = {{u"frame"_s, u"pixels"_s, u"truth"_s, u"toggled"_s, u"truth"_s}};
    for (std::size_t i = 0; i < study.frames.size(); ++i) {
        const MotionFrame &frame = study.frames[i];
        rows.push_back({QString::number(i), QString::number(frame.drawn),
                        QString::number(frame.truth), QString::number(frame.toggled),
                        QString::number(frame.truthToggled)});
    }
    return alignedRows(rows, [](qsizetype) { return false; })
        + QStringList{
            u"toggled in all: %1 (truth %2)"_s.arg(study.toggled()).arg(study.truthToggled())};
}

QJsonObject jsonOf(const MotionStudy &study)
{
    QJsonArray frames;
    for (const MotionFrame &frame : study.frames)
        frames.append(QJsonObject{{u"pixels"_s, qint64(frame.drawn)},
                                  {u"truth"_s, qint64(frame.truth)},
                                  {u"toggled"_s, qint64(frame.toggled)},
                                  {u"truthToggled"_s, qint64(frame.truthToggled)}});
    return {{u"frames"_s, frames},
            {u"toggled"_s, qint64(study.toggled())},
            {u"truthToggled"_s, qint64(study.truthToggled())}};
}

} // namespace

ExitCode motion(const Command &command, const QStringList &arguments)
{
    CommandLine line(command, {scenePositional()});
    line.addJsonOption();
    addSettingOptions(line);
    line.parse(arguments);
    if (line.isSet(u"frame"_s))
        refuse(InputError{u"--frame"_s, u"motion counts in all frames of the scene"_s,
                          u"it without --frame; one frame is drawn by “render --frame”"_s});
    const Scene scene = readScene(line, line.argument(0)).scene;
    if (!scene.motion)
        refuse(InputError{line.argument(0), u"the scene does not move"_s,
                          u"a scene with \"motion\": { \"by\": [x, y], \"frames\": n }"_s});
    const auto study = withProgress(
        [&](const ProgressListener &listener) { return studyMotion(scene, listener); });
    line.asksForJson() ? printJson(jsonOf(*study)) : printLines(motionLines(*study));
    return study->toggled() != study->truthToggled() ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
