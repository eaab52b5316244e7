// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/frame/framebuffer.h"
#include "core/lab/study/costorder.h"
#include "core/runs/tracedscene.h"
#include "core/scene/asciiraster.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString pictureOption = u"output"_s;
const QString asciiOption = u"ascii"_s;
const QString accuracyOption = u"accuracy"_s;
const QString scaleOption = u"scale"_s;

QStringList accuracyNames() { return {u"exact"_s, u"1-level"_s, u"10-ppm"_s}; }

/// What is drawn from scenes and where it is written.
struct RenderRequest {
    QStringList pictures; ///< one path per scene
    QString format; ///< of the pictures
    bool wantsPicture = false;
    bool wantsAscii = false;
    std::int64_t scale = 1;
    LayerRequest layers;
};

QImage pictureOf(const SceneRun &run, const RenderRequest &request)
{
    if (request.layers.asksForRun())
        return pictureWithLayers(run, request.layers, request.scale);
    const FrameBuffer frame(run.scene.frame);
    run.draw(frame.view());
    return enlarged(frame.image().copy(), request.scale); // the frame ends here
}

/// The scene with the cheapest method, by the published order of cost, that meets the budget.
SceneRun withinBudget(const Scene &scene, const QString &word)
{
    const QString place = u"--accuracy"_s;
    const auto budget = budgetNamed(word.toStdString());
    if (!budget || *budget == Budget::SixteenMilliseconds)
        refuseUnknown(place, u"accuracy"_s, word, accuracyNames());
    if (!scene.shapes.empty())
        refuse({place, u"the scene has other primitives than triangles"_s, u"triangles alone"_s});
    const auto choice = withProgress(
        [&](const ProgressListener &listener) { return firstInOrder(*budget, scene, listener); });
    if (!choice->contender)
        refuse({place, choice->reason, {}});
    sayLine(u"%1: %2, %3"_s.arg(word, choice->contender->id, choice->reason));
    return runWithProgress(sceneFor(scene, {choice->contender->method, choice->settings}));
}

SceneRun sceneToRender(const CommandLine &line, const QString &path)
{
    if (!line.isSet(accuracyOption))
        return readScene(line, path);
    return withinBudget(readSceneForAnyMethod(line, path), line.value(accuracyOption));
}

ExitCode renderScene(const RenderRequest &request, const NamedScene &named,
                     const QString &outputPath)
{
    const SceneRun &run = *named.run;
    const QString drawnBy = named.path + u", "_s + run.method->id;
    reportRejections(drawnBy, rejectedPrimitives(run));
    if (request.wantsPicture) {
        Output output(outputPath);
        writePicture(pictureOf(run, request), output, request.format);
    }
    if (request.wantsAscii)
        printLines(asciiRaster(coverageOf(run)).chopped(1).split(u'\n'));
    return ExitCode::Done;
}

RenderRequest requestFrom(const CommandLine &line)
{
    RenderRequest request;
    request.wantsPicture = line.isSet(pictureOption);
    request.wantsAscii = line.isSet(asciiOption);
    if (!request.wantsPicture && !request.wantsAscii)
        refuse({{}, u"nothing to do"_s, u"-o FILE, --ascii or both"_s});
    if (const QString output = line.value(pictureOption);
        request.wantsAscii && request.wantsPicture && isStandardOutput(output))
        refuse({{}, u"-o %1 and --ascii both need standard output"_s.arg(output), u"one"_s});
    if (line.isSet(accuracyOption) && (line.isSet(u"method"_s) || line.isSet(u"arithmetic"_s)))
        refuse({{}, u"--accuracy chooses method and arithmetic itself"_s, u"it alone"_s});
    request.scale = wholeNumberOf(line, scaleOption, {1, 64}).value();
    request.layers = layerRequestFrom(line);
    if (request.layers.asksForRun() && !request.wantsPicture)
        refuse({{}, u"--layers and --position need a picture"_s, u"-o FILE"_s});
    if (line.isSet(scaleOption) && !request.wantsPicture)
        refuse({{}, u"--scale needs a picture"_s, u"-o FILE"_s});
    if (request.wantsPicture) {
        request.pictures
            = outputPaths(line.value(pictureOption), line.arguments(), pictureFormats().front());
        request.format = pictureFormatOf(u"-o"_s, request.pictures.front());
    }
    return request;
}

} // namespace

ExitCode render(const Command &command, const QStringList &arguments)
{
    CommandLine line(command, {scenesPositional()});
    line.addOption(
        {{u"o"_s, pictureOption},
         u"Write the picture: PNG, BMP or PPM by the name's end; - is standard output, as PNG. A "
         "folder, DIR/, gets each scene's picture as PNG under the scene's name."_s,
         u"file"_s});
    line.addOption(
        {asciiOption, u"Print the raster: # for each pixel that is written, . for others."_s});
    line.addOption(
        {scaleOption,
         u"Make each pixel of the picture a square of this many each way, 1 to 64; 1 if left out."_s,
         u"count"_s, u"1"_s});
    addLayerOptions(line);
    line.addOption(
        {accuracyOption,
         u"Draw by the cheapest way that is accurate enough, in the order that the manual prints: "
         "exact, 1-level, 10-ppm. In place of --method and --arithmetic."_s,
         u"budget"_s});
    addSettingOptions(line);
    line.parse(arguments);

    const RenderRequest request = requestFrom(line);
    const std::vector<NamedScene> scenes = readScenes(line, sceneToRender);
    ExitCode code = ExitCode::Done;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (request.wantsAscii && scenes.size() > 1)
            printLine(scenes[i].path + u':');
        code = std::max(code, !scenes[i].run ? ExitCode::Usage : endOf(line.command(), [&] {
                            return renderScene(request, scenes[i],
                                               request.pictures.value(qsizetype(i)));
                        }));
    }
    return code;
}

} // namespace pixelplumb::cli
