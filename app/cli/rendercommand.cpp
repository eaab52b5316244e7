// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/rejectionreport.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/suggestion.h"
#include "core/frame/framebuffer.h"
#include "core/lab/costorder.h"
#include "core/runs/tracedscene.h"
#include "core/scene/asciiraster.h"

#include <QFileInfo>
#include <QImageWriter>

namespace pixelplumb::cli {

namespace {

/// Formats without loss: each pixel can be read back.
const QStringList &pictureFormats()
{
    static const QStringList formats
        = {QStringLiteral("png"), QStringLiteral("bmp"), QStringLiteral("ppm")};
    return formats;
}

QStringList accuracyNames()
{
    return {QStringLiteral("exact"), QStringLiteral("1-level"), QStringLiteral("10-ppm")};
}

std::optional<InputError> writePicture(const Scene &scene, Output &output, const QString &format)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    if (auto error = output.open())
        return error;
    QImageWriter writer(&output.device(), format.toLatin1());
    if (!writer.write(frame.image()))
        return output.error(writer.errorString());
    return output.finish();
}

/// The scene drawn by the first of the published order of cost that meets the budget.
Result<Scene> withinBudget(const Scene &scene, const QString &word)
{
    const QString place = QStringLiteral("--accuracy");
    const auto budget = budgetNamed(word.toStdString());
    if (!budget || *budget == Budget::SixteenMilliseconds)
        return unknownName(place, QStringLiteral("accuracy"), word, accuracyNames());
    if (!scene.shapes.empty())
        return InputError{place, QStringLiteral("the scene has other primitives than triangles"),
                          QStringLiteral("triangles alone")};
    Progress progress;
    const auto choice = firstInOrder(*budget, scene, progress.listener());
    if (!choice->contender)
        return InputError{place, choice->reason, {}};
    sayLine(QStringLiteral("%1: %2, %3").arg(word, choice->contender->id, choice->reason));
    Scene drawn = scene;
    drawn.method = choice->contender->method->id.toStdString();
    drawn.settings = choice->settings;
    return drawn;
}

} // namespace

ExitCode render(const Command &command, const QStringList &arguments)
{
    const QString outputOption = QStringLiteral("output");
    const QString asciiOption = QStringLiteral("ascii");
    const QString accuracyOption = QStringLiteral("accuracy");
    CommandLine line(command, {scenePositional()});
    line.addOption(
        {{QStringLiteral("o"), outputOption},
         QStringLiteral("Write the picture: PNG, BMP or PPM by the name's end; - is standard "
                        "output, as PNG."),
         QStringLiteral("file")});
    line.addOption(
        {asciiOption,
         QStringLiteral("Print the raster: # for each pixel that is written, . for others.")});
    line.addOption({accuracyOption,
                    QStringLiteral("Draw by the cheapest way that is accurate enough, in the "
                                   "order that the manual prints: exact, 1-level, 10-ppm. In "
                                   "place of --method and --arithmetic."),
                    QStringLiteral("budget")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;

    const QString path = line.value(outputOption);
    const bool wantsPicture = line.isSet(outputOption);
    const bool wantsAscii = line.isSet(asciiOption);
    if (!wantsPicture && !wantsAscii)
        return line.refuse(QStringLiteral("nothing to do; expected -o FILE, --ascii or both"));
    if (wantsAscii && path == QStringLiteral("-"))
        return line.refuse(
            QStringLiteral("-o - and --ascii both need standard output; expected one"));
    // Standard output and names without an end, such as /dev/stdout, get the first of the formats.
    const QString suffix = path == QStringLiteral("-") ? QString() : QFileInfo(path).suffix();
    const QString format = suffix.isEmpty() ? pictureFormats().front() : suffix.toLower();
    if (wantsPicture && !pictureFormats().contains(format)) {
        return line.refuse(
            QStringLiteral("-o %1: unknown kind of picture; expected a name that ends in .")
                .arg(path)
            + pictureFormats().join(QStringLiteral(", .")));
    }

    if (line.isSet(accuracyOption)
        && (line.isSet(QStringLiteral("method")) || line.isSet(QStringLiteral("arithmetic"))))
        return line.refuse(
            QStringLiteral("--accuracy chooses method and arithmetic itself; expected it alone"));

    Result<Scene> scene
        = line.isSet(accuracyOption) ? readSceneForAnyMethod(line) : readScene(line);
    if (scene && line.isSet(accuracyOption))
        scene = withinBudget(*scene, line.value(accuracyOption));
    if (!scene)
        return line.refuse(scene.error());
    reportRejections(line.argument(0) + QStringLiteral(", ") + scene->method.c_str(),
                     rejectedPrimitives(*scene));
    if (wantsPicture) {
        Output output(path, line.argument(0));
        if (const auto error = writePicture(*scene, output, format))
            return line.refuse(*error);
    }
    if (wantsAscii)
        printLine(asciiRaster(coverageOf(*scene)).chopped(1));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
