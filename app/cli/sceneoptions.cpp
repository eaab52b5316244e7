// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/grade/bugs/defect.h"
#include "core/runs/clampeddepths.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"

#include <algorithm>
#include <array>

namespace pixelplumb::cli {

namespace {

constexpr QLatin1String methodOption("method");
constexpr QLatin1String arithmeticOption("arithmetic");
constexpr QLatin1String fillRuleOption("fill-rule");
constexpr QLatin1String roundingOption("rounding");
constexpr QLatin1String frameOption("frame");
constexpr QLatin1String variantOption("variant");
constexpr QLatin1String noVariant("none");

/// The variants chosen, separated by commas; together they replace the scene's.
VariantSet chosenVariants(const CommandLine &line, VariantSet unset)
{
    if (!line.isSet(variantOption))
        return unset;
    const QString list = line.value(variantOption);
    VariantSet variants;
    if (list == noVariant)
        return variants;
    for (const QString &name : list.split(u',')) {
        if (name.trimmed() == noVariant)
            refuse({u"--"_s + variantOption, u"“none” stands beside other names"_s,
                    u"none alone, or variants alone"_s});
        const auto variant = variantNamed(name.trimmed().toStdString());
        if (!variant)
            refuseUnknown(u"--"_s + variantOption, u"name"_s, name,
                          namesOf(allVariants) + QStringList{noVariant});
        if (variants.contains(*variant))
            refuse({u"--"_s + variantOption, u"“%1” is named twice"_s.arg(name.trimmed()),
                    u"each variant once"_s});
        variants = variants.with(*variant);
    }
    if (undoEachOther(variants))
        refuse({u"--"_s + variantOption, undoingText(), u"one of them, or none"_s});
    return variants;
}

/// Reports the first snapped coordinates one by one, the others as a count.
void reportSnaps(const QString &path, const SnapReports &snaps)
{
    constexpr std::size_t mostReported = 5;
    const std::size_t reported = std::min(snaps.size(), mostReported);
    for (std::size_t index = 0; index < reported; ++index)
        sayLine(path + u": "_s + snaps[index].message());
    if (snaps.size() > reported)
        sayLine(
            u"%1: %2 more like these: coordinates are rounded to 1/256 px, attributes to 2^-24"_s
                .arg(path, QString::number(snaps.size() - reported)));
}

QString drawsNoneText(const Scene &scene)
{
    return u"method “%1” draws none of the primitives"_s.arg(QString::fromStdString(scene.method));
}

} // namespace

Positional scenePositional()
{
    return {u"SCENE"_s, u"a scene file (JSON), or - for standard input"_s};
}

Positional scenesPositional()
{
    return {u"SCENE"_s, u"scene files (JSON), or - for standard input"_s,
            Positional::Presence::Several};
}

void addSettingOptions(CommandLine &line)
{
    const QString name = u"name"_s;
    line.addOption({methodOption, u"How to scan-convert; see the command methods."_s, name});
    line.addOption({arithmeticOption,
                    u"What to compute in: "_s + namesOf(allArithmetics).join(u", "_s) + u'.',
                    name});
    line.addOption(
        {fillRuleOption,
         u"Who owns a sample on an edge: "_s + namesOf(allFillRules).join(u", "_s) + u'.', name});
    line.addOption(
        {roundingOption,
         u"How a level becomes a byte: "_s + namesOf(allByteRoundings).join(u", "_s) + u'.', name});
    line.addOption({frameOption, u"Which frame of a moving scene to use, from 0; 0 if left out."_s,
                    u"number"_s});
    line.addOption(
        {variantOption,
         u"Depart from the right algorithm, to see what that does; several with commas: "_s
             + namesOf(allVariants).join(u", "_s) + u'.',
         name});
    addForceOption(line);
}

QStringList methodIds()
{
    QStringList ids;
    for (const Method &method : methods())
        ids.append(method.id);
    return ids;
}

const Method *chosenMethod(const CommandLine &line, const QString &unset)
{
    const QString id = line.isSet(methodOption) ? line.value(methodOption) : unset;
    if (const Method *method = methodNamed(id))
        return method;
    refuseUnknownAmongMany(u"--"_s + methodOption, u"name"_s, id, methodIds(),
                           u"a method that “pixelplumb-cli methods” lists"_s);
}

Arithmetic chosenArithmetic(const CommandLine &line, Arithmetic unset)
{
    return chosen(line, arithmeticOption, allArithmetics, unset);
}

FillRule chosenFillRule(const CommandLine &line, FillRule unset)
{
    return chosen(line, fillRuleOption, allFillRules, unset);
}

std::optional<InputError> refusalOf(const SceneRun &run, const QString &path)
{
    const QString objection = objectionTo(run);
    if (objection.isEmpty())
        return std::nullopt;
    return InputError{path, u"method “%1” %2"_s.arg(run.method->id, objection), {}};
}

SceneReading sceneIn(const QByteArray &text, const QString &path)
{
    Result<SceneReading> reading = pixelplumb::readScene(text, {}, folderOf(path));
    if (!reading)
        refuse(errorIn(path, reading.error()));
    reportSnaps(path, reading->snaps);
    return std::move(*reading);
}

SceneReading readSceneAt(const QString &path) { return sceneIn(readInput(path), path); }

namespace {

/// What neither the scene nor an option names.
OpenSettings openUnder(const CommandLine &line, const OpenSettings &inScene)
{
    return {inScene.method && !line.isSet(methodOption),
            inScene.arithmetic && !line.isSet(arithmeticOption),
            inScene.fillRule && !line.isSet(fillRuleOption)};
}

} // namespace

Scene underOptions(const CommandLine &line, SceneReading reading, const QString &path)
{
    Scene scene = std::move(reading.scene);
    auto method = chosenMethod(line, QString::fromStdString(scene.method));
    const auto arithmetic = chosenArithmetic(line, scene.settings.arithmetic);
    const auto fillRule = chosenFillRule(line, scene.settings.fillRule);
    const auto forced = chosenForcing(line);
    // Before the method is chosen, which must draw what is forced on.
    scene.appearance.forced = forced;
    const OpenSettings open = openUnder(line, reading.open);
    scene.settings.arithmetic = arithmetic;
    scene.settings.fillRule = fillRule;
    scene.settings.variants = chosenVariants(line, scene.settings.variants);
    if (open.method)
        method = &methodFor(scene, open);
    scene.settings = settledFor(*method, scene.settings, open);
    const auto rounding = chosen(line, roundingOption, allByteRoundings, scene.settings.rounding);
    if (line.isSet(frameOption)) {
        if (!scene.motion)
            refuse({u"--"_s + frameOption, u"%1 does not move"_s.arg(path),
                    u"a scene with “motion”"_s});
        const auto frame = wholeNumberOf(line, frameOption,
                                         {0, scene.motion->frames - 1, u"no frame of the scene"_s});
        scene = sceneAtFrame(scene, int(*frame));
    }
    scene.method = method->id.toStdString();
    scene.settings.rounding = rounding;
    return scene;
}

Scene readSceneForAnyMethod(const CommandLine &line, const QString &path)
{
    return underOptions(line, readSceneAt(path), path);
}

SceneRun readScene(const CommandLine &line, const QString &path)
{
    SceneReading reading = readSceneAt(path);
    const OpenSettings open = openUnder(line, reading.open);
    SceneRun run = runWithProgress(underOptions(line, std::move(reading), path));
    const Scene &scene = run.scene;
    if (open.method && !run.method->objection(scene.settings).isEmpty())
        refuse({path, refusalOfAll(scene, open), {}});
    refuseIf(refusalOf(run, path));
    // A scene may name a method for things yet to be drawn; this explains the empty picture.
    if (!drawsAnyOf(scene))
        sayLine(u"%1: %2; see `pixelplumb-cli methods` for one that does"_s.arg(
            path, drawsNoneText(scene)));
    if (scene.appearance.depthFormat != DepthFormat::Exact) {
        if (const QString clamped = clampedDepthsText(run.primitives); !clamped.isEmpty())
            sayLine(path + u": "_s + clamped);
    }
    return run;
}

std::vector<NamedScene> readScenes(const CommandLine &line, SceneReader read)
{
    std::vector<NamedScene> scenes;
    for (const QString &path : line.arguments()) {
        NamedScene &named = scenes.emplace_back(NamedScene{path, std::nullopt});
        endOf(line.command(), [&] {
            named.run.emplace(read(line, path));
            return ExitCode::Done;
        });
    }
    return scenes;
}

void refuseToJudgeBy(const Scene &scene, const QString &path)
{
    if (!drawsAnyOf(scene))
        refuse({path, drawsNoneText(scene),
                u"a method that draws one, in the scene or as --method"_s});
}

SceneRun runWithProgress(const Scene &scene)
{
    return *withProgress(
        [&](const ProgressListener &listener) { return sceneRunOf(scene, listener); });
}

std::shared_ptr<const TracedScene> tracedWithProgress(SceneRun run)
{
    return withProgress([&run](const ProgressListener &listener) {
        TraceOptions recording;
        recording.progress = listener;
        return traceScene(std::move(run), recording);
    });
}

WholeRange primitivesOf(const ScanTrace &trace)
{
    return {0, std::int64_t(trace.primitiveCount()) - 1, u"no primitive of the scene"_s};
}

void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected)
{
    constexpr std::size_t mostReported = 5;
    const std::size_t reported = std::min(rejected.size(), mostReported);
    for (std::size_t i = 0; i < reported; ++i)
        sayLine(drawnBy + u": "_s + rejected[i].message());
    if (rejected.size() > reported)
        sayLine(u"%1: %2 more primitives are not drawn"_s.arg(
            drawnBy, QString::number(rejected.size() - reported)));
}

} // namespace pixelplumb::cli
