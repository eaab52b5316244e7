// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/frame/framebuffer.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/hunt/counterexample.h"
#include "core/scene/files/filepath.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/colourtext.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

/// The index in the sources of the side that departs: not the one that is right by proof.
std::size_t partingSide(const Sides &sides)
{
    return sides.sources[1].isStable && !sides.sources[0].isStable ? 0 : 1;
}

std::optional<PartingStep> partingStepOf(const Sides &sides, const Scene &scene)
{
    const PictureSource &parting = sides.sources[partingSide(sides)];
    const PictureSource &right = sides.sources[1 - partingSide(sides)];
    if (!right.runOf || !parting.runOf)
        return std::nullopt;
    const auto rightRun = right.runOf(scene);
    const auto partingRun = parting.runOf(scene);
    if (!rightRun || !partingRun)
        return std::nullopt;
    const Scene defective = withDefects(rightRun->scene, rightRun->defects);
    if (defective == partingRun->scene)
        return pixelplumb::partingStepOf(defective, partingRun->defects);
    return pixelplumb::partingStepOf(defective,
                                     withDefects(partingRun->scene, partingRun->defects));
}

struct DifferingPixel {
    std::int64_t x = 0, y = 0;
    Colour one, other;
};

std::vector<DifferingPixel> differingPixelsOf(const CounterExample &example)
{
    std::vector<DifferingPixel> pixels;
    const FrameSpec &frame = example.scene.frame;
    for (int line = 0; line < frame.height; ++line) {
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t place = example.one.placeOf(x, line);
            if (example.one.colours[place] != example.other.colours[place])
                pixels.push_back({frame.firstColumn + x, rowOfPictureLine(frame, line),
                                  example.one.colours[place], example.other.colours[place]});
        }
    }
    return pixels;
}

QStringList undrawnLines(const CounterSearch &search)
{
    if (!search.firstUndrawn)
        return {};
    return {QStringLiteral("%1 could not be drawn; the first: %2")
                .arg(search.undrawn)
                .arg(undrawnText(*search.firstUndrawn))};
}

QStringList linesOf(const Sides &sides, const CounterSearch &search)
{
    const auto &sources = sides.sources;
    if (!search.found) {
        QStringList lines
            = {QStringLiteral("none found: %1 and %2 draw the same in %3 scenes")
                   .arg(sources[0].name, sources[1].name, QString::number(search.compared))};
        return lines + undrawnLines(search);
    }
    const CounterExample &example = *search.found;
    const FrameSpec &frame = example.scene.frame;
    QStringList lines = {QStringLiteral("%1 × %2 pixels, scene %3 of the search")
                             .arg(frame.width)
                             .arg(frame.height)
                             .arg(search.tried)};
    lines += primitiveLines(example.scene);
    constexpr std::size_t mostListed = 8;
    const auto pixels = differingPixelsOf(example);
    for (std::size_t i = 0; i < std::min(pixels.size(), mostListed); ++i)
        lines += withMinus(QStringLiteral("pixel (%1, %2)").arg(pixels[i].x).arg(pixels[i].y))
            + QStringLiteral(": %1 has %2, %3 %4")
                  .arg(sources[0].name, colourText(pixels[i].one), sources[1].name,
                       colourText(pixels[i].other));
    if (pixels.size() > mostListed)
        lines += QStringLiteral("and %1 pixels more").arg(pixels.size() - mostListed);
    if (const auto step = partingStepOf(sides, example.scene))
        lines += QStringLiteral("%1 parts at step %2, %3: %4")
                     .arg(sources[partingSide(sides)].name, QString::number(step->step + 1),
                          step->heading, step->text);
    return lines + undrawnLines(search);
}

QJsonObject jsonOf(const Sides &sides, const CounterSearch &search)
{
    QJsonObject object{{QStringLiteral("one"), sides.sources[0].name},
                       {QStringLiteral("other"), sides.sources[1].name},
                       {QStringLiteral("tried"), qint64(search.tried)},
                       {QStringLiteral("compared"), qint64(search.compared)},
                       {QStringLiteral("undrawn"), qint64(search.undrawn)},
                       {QStringLiteral("found"), search.found.has_value()}};
    if (search.firstUndrawn)
        object.insert(QStringLiteral("firstUndrawn"), undrawnJson(*search.firstUndrawn));
    if (sides.hasProgram())
        addConfinement(object);
    if (!search.found)
        return object;
    const Scene &scene = search.found->scene;
    object.insert(QStringLiteral("scene"), QJsonDocument::fromJson(writeScene(scene)).object());
    QJsonArray pixels;
    for (const DifferingPixel &pixel : differingPixelsOf(*search.found))
        pixels.append(QJsonObject{{QStringLiteral("x"), qint64(pixel.x)},
                                  {QStringLiteral("y"), qint64(pixel.y)},
                                  {QStringLiteral("one"), colourText(pixel.one)},
                                  {QStringLiteral("other"), colourText(pixel.other)}});
    object.insert(QStringLiteral("pixels"), pixels);
    if (const auto step = partingStepOf(sides, scene))
        object.insert(QStringLiteral("parts"),
                      QJsonObject{{QStringLiteral("step"), qint64(step->step + 1)},
                                  {QStringLiteral("at"), step->heading},
                                  {QStringLiteral("how"), step->text}});
    return object;
}

/// Where the scene is to be written; checked before the search, which takes long.
QString pathIn(const QString &output)
{
    refuseStandardOutput(output, QStringLiteral("a file"));
    const auto paths
        = outputPaths(output, {QStringLiteral("counterexample")}, QStringLiteral("json"));
    refuseIf(refusalToWrite(paths.front()));
    const QFileInfo file(filePath(paths.front()));
    const QFileInfo folder(file.path());
    if (!file.exists() && !(folder.isDir() && folder.isWritable()))
        refuse({QStringLiteral("-o ") + output,
                QStringLiteral("the folder %1 takes no file").arg(folder.filePath()),
                QStringLiteral("a file in a folder that is there and can be written to")});
    return paths.front();
}

} // namespace

ExitCode counterExample(const Command &command, const QStringList &arguments)
{
    const QString outputOption = QStringLiteral("output");
    const QString what = sideMeaning();
    CommandLine line(command, {{QStringLiteral("ONE"), what}, {QStringLiteral("OTHER"), what}});
    addSeedOption(line, QStringLiteral("scenes"));
    line.addOption({{QStringLiteral("o"), outputOption},
                    QStringLiteral("Write the scene, too: JSON. A folder, DIR/, gets it as "
                                   "counterexample.json."),
                    QStringLiteral("file")});
    line.addJsonOption();
    addProgramOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const auto seed = chosenSeed(line);
    const Sides sides = sidesOf(line, {QStringLiteral("ONE"), QStringLiteral("OTHER")});
    const QString path = line.isSet(outputOption) ? pathIn(line.value(outputOption)) : QString();
    const CounterSearch search = withProgress([&](const ProgressListener &listener) {
        return findCounterExample(sides.sources[0], sides.sources[1], sides.conventions, seed,
                                  listener);
    });
    const QStringList confinement = sides.hasProgram() ? confinementLines() : QStringList();
    if (search.compared == 0) {
        sayLine(QStringLiteral("%1 and %2 have no picture of the same scene: of %3 that were asked "
                               "for none was drawn by both")
                    .arg(sides.sources[0].name, sides.sources[1].name,
                         QString::number(search.undrawn)));
        if (search.firstUndrawn)
            sayLine(QStringLiteral("the first: ") + undrawnText(*search.firstUndrawn));
        for (const QString &each : confinement)
            sayLine(each);
        if (line.asksForJson())
            printJson(jsonOf(sides, search));
        return ExitCode::FallsShort;
    }
    line.asksForJson() ? printJson(jsonOf(sides, search))
                       : printLines(linesOf(sides, search) + confinement);
    if (search.found && line.isSet(outputOption))
        refuseIf(writeSceneFile(path, search.found->scene));
    return search.found || search.undrawn > 0 ? ExitCode::FallsShort : ExitCode::Done;
}

} // namespace pixelplumb::cli
