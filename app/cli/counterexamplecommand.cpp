// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
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
    return {u"%1 could not be drawn; the first: %2"_s.arg(search.undrawn)
                .arg(undrawnText(*search.firstUndrawn))};
}

QStringList linesOf(const Sides &sides, const CounterSearch &search)
{
    const auto &sources = sides.sources;
    if (!search.found) {
        QStringList lines = {u"none found: %1 and %2 draw the same in %3 scenes"_s.arg(
            sources[0].name, sources[1].name, QString::number(search.compared))};
        return lines + undrawnLines(search);
    }
    const CounterExample &example = *search.found;
    const FrameSpec &frame = example.scene.frame;
    QStringList lines = {u"%1 × %2 pixels, scene %3 of the search"_s.arg(frame.width)
                             .arg(frame.height)
                             .arg(search.tried)};
    lines += primitiveLines(example.scene);
    constexpr std::size_t mostListed = 8;
    const auto pixels = differingPixelsOf(example);
    for (std::size_t i = 0; i < std::min(pixels.size(), mostListed); ++i)
        lines += withMinus(u"pixel (%1, %2)"_s.arg(pixels[i].x).arg(pixels[i].y))
            + u": %1 has %2, %3 %4"_s.arg(sources[0].name, colourText(pixels[i].one),
                                          sources[1].name, colourText(pixels[i].other));
    if (pixels.size() > mostListed)
        lines += u"and %1 pixels more"_s.arg(pixels.size() - mostListed);
    if (const auto step = partingStepOf(sides, example.scene))
        lines += u"%1 parts at step %2, %3: %4"_s.arg(sources[partingSide(sides)].name,
                                                      QString::number(step->step + 1),
                                                      step->heading, step->text);
    return lines + undrawnLines(search);
}

QJsonObject jsonOf(const Sides &sides, const CounterSearch &search)
{
    QJsonObject object{
        {u"one"_s, sides.sources[0].name},      {u"other"_s, sides.sources[1].name},
        {u"tried"_s, qint64(search.tried)},     {u"compared"_s, qint64(search.compared)},
        {u"undrawn"_s, qint64(search.undrawn)}, {u"found"_s, search.found.has_value()}};
    if (search.firstUndrawn)
        object.insert(u"firstUndrawn"_s, undrawnJson(*search.firstUndrawn));
    if (sides.hasProgram())
        addConfinement(object);
    if (!search.found)
        return object;
    const Scene &scene = search.found->scene;
    object.insert(u"scene"_s, QJsonDocument::fromJson(writeScene(scene)).object());
    QJsonArray pixels;
    for (const DifferingPixel &pixel : differingPixelsOf(*search.found))
        pixels.append(QJsonObject{{u"x"_s, qint64(pixel.x)},
                                  {u"y"_s, qint64(pixel.y)},
                                  {u"one"_s, colourText(pixel.one)},
                                  {u"other"_s, colourText(pixel.other)}});
    object.insert(u"pixels"_s, pixels);
    if (const auto step = partingStepOf(sides, scene))
        object.insert(u"parts"_s,
                      QJsonObject{{u"step"_s, qint64(step->step + 1)},
                                  {u"at"_s, step->heading},
                                  {u"how"_s, step->text}});
    return object;
}

/// Where the scene is to be written; checked before the search, which takes long.
QString pathIn(const QString &output)
{
    refuseStandardOutput(output, u"a file"_s);
    const auto paths = outputPaths(output, {u"counterexample"_s}, u"json"_s);
    refuseIf(refusalToWrite(paths.front()));
    const QFileInfo file(filePath(paths.front()));
    const QFileInfo folder(file.path());
    if (!file.exists() && !(folder.isDir() && folder.isWritable()))
        refuse({u"-o "_s + output, u"the folder %1 takes no file"_s.arg(folder.filePath()),
                u"a file in a folder that is there and can be written to"_s});
    return paths.front();
}

} // namespace

ExitCode counterExample(const Command &command, const QStringList &arguments)
{
    const QString outputOption = u"output"_s;
    const QString what = sideMeaning();
    CommandLine line(command, {{u"ONE"_s, what}, {u"OTHER"_s, what}});
    addSeedOption(line, u"scenes"_s);
    line.addOption(
        {{u"o"_s, outputOption},
         u"Write the scene, too: JSON. A folder, DIR/, gets it as counterexample.json."_s,
         u"file"_s});
    line.addJsonOption();
    addProgramOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const auto seed = chosenSeed(line);
    const Sides sides = sidesOf(line, {u"ONE"_s, u"OTHER"_s});
    const QString path = line.isSet(outputOption) ? pathIn(line.value(outputOption)) : QString();
    const CounterSearch search = withProgress([&](const ProgressListener &listener) {
        return findCounterExample(sides.sources[0], sides.sources[1], sides.conventions, seed,
                                  listener);
    });
    const QStringList confinement = sides.hasProgram() ? confinementLines() : QStringList();
    if (search.compared == 0) {
        sayLine(u"%1 and %2 have no picture of the same scene: of %3 that were asked for none was "
                "drawn by both"_s.arg(sides.sources[0].name, sides.sources[1].name,
                                      QString::number(search.undrawn)));
        if (search.firstUndrawn)
            sayLine(u"the first: "_s + undrawnText(*search.firstUndrawn));
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
