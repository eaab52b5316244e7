// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
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
            refuse({QStringLiteral("--") + variantOption,
                    QStringLiteral("“none” stands beside other names"),
                    QStringLiteral("none alone, or variants alone")});
        const auto variant = variantNamed(name.trimmed().toStdString());
        if (!variant)
            refuseUnknown(QStringLiteral("--") + variantOption, QStringLiteral("name"), name,
                          namesOf(allVariants) + QStringList{noVariant});
        if (variants.contains(*variant))
            refuse({QStringLiteral("--") + variantOption,
                    QStringLiteral("“%1” is named twice").arg(name.trimmed()),
                    QStringLiteral("each variant once")});
        variants = variants.with(*variant);
    }
    if (undoEachOther(variants))
        refuse({QStringLiteral("--") + variantOption, undoingText(),
                QStringLiteral("one of them, or none")});
    return variants;
}

/// Reports the first snapped coordinates one by one, the others as a count.
void reportSnaps(const QString &path, const SnapReports &snaps)
{
    constexpr std::size_t mostReported = 5;
    const std::size_t reported = std::min(snaps.size(), mostReported);
    for (std::size_t index = 0; index < reported; ++index)
        sayLine(path + QStringLiteral(": ") + snaps[index].message());
    if (snaps.size() > reported)
        sayLine(QStringLiteral("%1: %2 more like these: coordinates are rounded to 1/256 px, "
                               "attributes to 2^-24")
                    .arg(path, QString::number(snaps.size() - reported)));
}

QString drawsNoneText(const Scene &scene)
{
    return QStringLiteral("method “%1” draws none of the primitives")
        .arg(QString::fromStdString(scene.method));
}

} // namespace

Positional scenePositional()
{
    return {QStringLiteral("SCENE"),
            QStringLiteral("a scene file (JSON), or - for standard input")};
}

Positional scenesPositional()
{
    return {QStringLiteral("SCENE"), QStringLiteral("scene files (JSON), or - for standard input"),
            Positional::Presence::Several};
}

void addSettingOptions(CommandLine &line)
{
    const QString name = QStringLiteral("name");
    line.addOption(
        {methodOption, QStringLiteral("How to scan-convert; see the command methods."), name});
    line.addOption({arithmeticOption,
                    QStringLiteral("What to compute in: ")
                        + namesOf(allArithmetics).join(QStringLiteral(", ")) + u'.',
                    name});
    line.addOption({fillRuleOption,
                    QStringLiteral("Who owns a sample on an edge: ")
                        + namesOf(allFillRules).join(QStringLiteral(", ")) + u'.',
                    name});
    line.addOption({roundingOption,
                    QStringLiteral("How a level becomes a byte: ")
                        + namesOf(allByteRoundings).join(QStringLiteral(", ")) + u'.',
                    name});
    line.addOption({frameOption,
                    QStringLiteral("Which frame of a moving scene to use, from 0; 0 if left out."),
                    QStringLiteral("number")});
    line.addOption(
        {variantOption,
         QStringLiteral("Depart from the right algorithm, to see what that does; several "
                        "with commas: ")
             + namesOf(allVariants).join(QStringLiteral(", ")) + u'.',
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
    refuseUnknownAmongMany(QStringLiteral("--") + methodOption, QStringLiteral("name"), id,
                           methodIds(),
                           QStringLiteral("a method that “pixelplumb-cli methods” lists"));
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
    return InputError{path, QStringLiteral("method “%1” %2").arg(run.method->id, objection), {}};
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
            refuse({QStringLiteral("--") + frameOption,
                    QStringLiteral("%1 does not move").arg(path),
                    QStringLiteral("a scene with “motion”")});
        const auto frame
            = wholeNumberOf(line, frameOption,
                            {0, scene.motion->frames - 1, QStringLiteral("no frame of the scene")});
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
        sayLine(QStringLiteral("%1: %2; see `pixelplumb-cli methods` for one that does")
                    .arg(path, drawsNoneText(scene)));
    if (scene.appearance.depthFormat != DepthFormat::Exact) {
        if (const QString clamped = clampedDepthsText(run.primitives); !clamped.isEmpty())
            sayLine(path + QStringLiteral(": ") + clamped);
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
                QStringLiteral("a method that draws one, in the scene or as --method")});
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
    return {0, std::int64_t(trace.primitiveCount()) - 1,
            QStringLiteral("no primitive of the scene")};
}

void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected)
{
    constexpr std::size_t mostReported = 5;
    const std::size_t reported = std::min(rejected.size(), mostReported);
    for (std::size_t i = 0; i < reported; ++i)
        sayLine(drawnBy + QStringLiteral(": ") + rejected[i].message());
    if (rejected.size() > reported)
        sayLine(QStringLiteral("%1: %2 more primitives are not drawn")
                    .arg(drawnBy, QString::number(rejected.size() - reported)));
}

} // namespace pixelplumb::cli
