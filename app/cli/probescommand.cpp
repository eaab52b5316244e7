// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/outputpaths.h"
#include "app/cli/picturesides.h"
#include "app/cli/progress.h"
#include "app/cli/sceneoptions.h"
#include "app/cli/seedoption.h"
#include "app/cli/wholenumber.h"
#include "core/grade/probesheet.h"
#include "core/scene/inputrecord.h"
#include "core/scene/outputfolder.h"
#include "core/scene/scenefile.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

/// The vertices' coordinates, one after the other: "(13 1/2, 6)".
QString placesOf(const std::vector<Vertex> &vertices)
{
    QString text;
    const auto number
        = [](Lattice coordinate) { return toText(Quantity::rational(coordinate, unitsPerPixel)); };
    for (const Vertex &vertex : vertices)
        text
            += QStringLiteral("(%1, %2)").arg(number(vertex.position.x), number(vertex.position.y));
    return text;
}

QString probeLine(const Scene &scene)
{
    QStringList primitives;
    for (const Triangle &triangle : scene.triangles)
        primitives += placesOf(std::vector(triangle.vertices.begin(), triangle.vertices.end()));
    for (const Shape &shape : scene.shapes)
        primitives += placesOf(shape.vertices);
    return QStringLiteral("%1 × %2: %3")
        .arg(scene.frame.width)
        .arg(scene.frame.height)
        .arg(primitives.join(QStringLiteral("; ")));
}

QStringList idsOf(const AlikeDefects &group)
{
    QStringList ids;
    for (const Defect &defect : group.defects)
        ids += defect.id;
    return ids;
}

QStringList linesOf(const std::vector<Scene> &scenes, const ProbeResult &result)
{
    QStringList lines;
    for (const Scene &scene : scenes)
        lines += probeLine(scene);
    lines += QStringLiteral("%1 defects: %2 pictures told apart, the right ones among them")
                 .arg(result.defects)
                 .arg(result.distinct());
    for (const AlikeDefects &group : result.alike)
        lines += (group.equalRight ? QStringLiteral("does not show: ") : QStringLiteral("alike: "))
            + idsOf(group).join(QStringLiteral(", "));
    return lines;
}

QJsonObject jsonOf(const std::vector<Scene> &scenes, const ProbeResult &result)
{
    QJsonArray sheet;
    for (const Scene &scene : scenes)
        sheet.append(QJsonDocument::fromJson(writeScene(scene)).object());
    QJsonArray alike;
    for (const AlikeDefects &group : result.alike)
        alike.append(
            QJsonObject{{QStringLiteral("equalRight"), group.equalRight},
                        {QStringLiteral("defects"), QJsonArray::fromStringList(idsOf(group))}});
    return {{QStringLiteral("scenes"), sheet},
            {QStringLiteral("defects"), qint64(result.defects)},
            {QStringLiteral("distinct"), qint64(result.distinct())},
            {QStringLiteral("alike"), alike}};
}

/// The assignment's conventions: a scene's, or the default scene's.
Result<Scene> conventionsFor(const CommandLine &line)
{
    const QString path = line.argument(0);
    SceneReading asWritten;
    if (!path.isEmpty()) {
        Result<SceneReading> read = readSceneAt(path);
        if (!read)
            return read.error();
        asWritten = std::move(*read);
    }
    const QString place = path.isEmpty() ? QStringLiteral("--method") : path;
    Result<Scene> scene = underOptions(line, std::move(asWritten), place);
    if (!scene)
        return scene;
    const Method &method = *methodNamed(QString::fromStdString(scene->method));
    if (const auto refusal = refusalToSearch(method, place))
        return *refusal;
    if (const QString refusal = method.refusal(scene->settings); !refusal.isEmpty())
        return InputError{place, refusal, {}};
    return scene;
}

/// Why a sheet cannot be written into a folder, which is made if need be; checked before the
/// search, which takes long and decides how many scenes there are.
std::optional<InputError> refusalOfSheet(const QString &folder, const Scene &conventions)
{
    if (auto refusal = refusalOfStandardOutput(folder, QStringLiteral("a folder")))
        return refusal;
    if (auto refusal = refusalOfFolder(folder))
        return refusal;
    const QString names = QString::fromStdString(conventions.method) + QStringLiteral("-*.json");
    for (const QString &name : QDir(folder).entryList({names})) {
        if (auto refusal = refusalToWrite(QDir(folder).filePath(name)))
            return refusal;
    }
    return std::nullopt;
}

std::optional<InputError> writeSheet(const QString &folder, const std::vector<Scene> &scenes)
{
    QStringList names;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        names += QStringLiteral("%1-%2").arg(QString::fromStdString(scenes[i].method),
                                             QString::number(i + 1));
    const auto paths = outputPaths(folder + u'/', names, QStringLiteral("json"));
    if (!paths)
        return paths.error();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (auto error = writeSceneFile(paths->at(qsizetype(i)), scenes[i]))
            return error;
    }
    return std::nullopt;
}

/// Prints a line per defect: its id and what was done.
void printDefects(const std::vector<Defect> &defects)
{
    QStringList lines;
    for (const Defect &defect : defects)
        lines += QStringLiteral("%1  %2").arg(defect.id, -28).arg(defect.forAssistant);
    printLines(lines);
}

void printDefectsAsJson(const std::vector<Defect> &defects)
{
    QJsonArray array;
    for (const Defect &defect : defects)
        array.append(QJsonObject{{QStringLiteral("id"), defect.id},
                                 {QStringLiteral("student"), defect.forStudent},
                                 {QStringLiteral("assistant"), defect.forAssistant}});
    printJson(QJsonDocument(array));
}

} // namespace

ExitCode probes(const Command &command, const QStringList &arguments)
{
    const QString outputOption = QStringLiteral("output");
    const QString candidatesOption = QStringLiteral("candidates");
    const QString jsonOption = QStringLiteral("json");
    const QString listOption = QStringLiteral("list");
    CommandLine line(command,
                     {{QStringLiteral("SCENE"),
                       QStringLiteral("a scene with the assignment's conventions: method, "
                                      "settings, origin and pixel centre; its primitives do not "
                                      "matter"),
                       Positional::Presence::Optional}});
    line.addOption({{QStringLiteral("o"), outputOption},
                    QStringLiteral("Write the scenes into this folder."),
                    QStringLiteral("folder")});
    addSeedOption(line, QStringLiteral("scenes"));
    line.addOption({candidatesOption,
                    QStringLiteral("Choose from so many random scenes; 240 if left out."),
                    QStringLiteral("count"), QStringLiteral("240")});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    line.addOption(
        {listOption, QStringLiteral("List the known defects of the method, and search nothing.")});
    addSettingOptions(line);
    if (const auto ended = line.parse(arguments))
        return *ended;
    const auto seed = chosenSeed(line);
    const auto candidates = wholeNumberOf(line, candidatesOption, {1, 100'000});
    if (!seed)
        return line.refuse(seed.error());
    if (!candidates)
        return line.refuse(candidates.error());
    const Result<Scene> conventions = conventionsFor(line);
    if (!conventions)
        return line.refuse(conventions.error());
    if (line.isSet(listOption) && (line.isSet(candidatesOption) || isSeedSet(line)))
        return line.refuse(QStringLiteral("--list searches nothing and makes no random scenes; "
                                          "expected it without --seed and --candidates"));
    if (line.isSet(listOption) && line.isSet(outputOption))
        return line.refuse(QStringLiteral("--list searches nothing, and there is nothing to write; "
                                          "expected it without -o"));
    if (line.isSet(outputOption)) {
        if (const auto refusal = refusalOfSheet(line.value(outputOption), *conventions))
            return line.refuse(*refusal);
    }
    if (line.isSet(listOption)) {
        const std::vector<Defect> defects = defectsOfMethod(*conventions);
        line.isSet(jsonOption) ? printDefectsAsJson(defects) : printDefects(defects);
        return ExitCode::Done;
    }
    const auto scenes = withProgress([&](const ProgressListener &listener) {
        return searchProbes(*conventions, *seed, candidates->value(), listener);
    });
    const ProbeResult result = probe(*scenes);
    if (line.isSet(jsonOption))
        printJson(QJsonDocument(jsonOf(*scenes, result)));
    else
        printLines(linesOf(*scenes, result));
    if (line.isSet(outputOption)) {
        if (const auto error = writeSheet(line.value(outputOption), *scenes))
            return line.refuse(*error);
    }
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
