// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/geometry/effect.h"
#include "core/grade/hunt/counterexample.h"
#include "core/grade/hunt/trial.h"
#include "core/methods/method.h"
#include "core/runs/contender.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "core/scan/scansettings.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/result.h"

#include <QJsonObject>

#include <array>
#include <limits>

namespace pixelplumb::cli {

struct WholeRange {
    std::int64_t first = 0;
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
    QString outside = u"out of range"_s; ///< "5 is out of range"
};

/// Reads the word as a whole number in the range; a refusal names the place ("--limit", "X"), the
/// word and the range.
std::int64_t wholeNumber(const QString &place, const QString &word, const WholeRange &range);

/// Reads an option's number; none where it is not set and has no default.
std::optional<std::int64_t> wholeNumberOf(const CommandLine &line, const QString &option,
                                          const WholeRange &range);

/// The choice that an option names by its nameOf(), `unset` where the option is not set. Another
/// word is refused with the names; `what` it should have named: "budget".
template <class Choice, std::size_t Count>
Choice chosen(const CommandLine &line, const QString &option,
              const std::array<Choice, Count> &choices, Choice unset,
              const QString &what = u"name"_s)
{
    if (!line.isSet(option))
        return unset;
    const QStringList names = namesOf(choices);
    const qsizetype index = names.indexOf(line.value(option));
    if (index < 0)
        refuseUnknown(u"--"_s + option, what, line.value(option), names);
    return choices[std::size_t(index)];
}

/// Adds --seed, 1 by default; `what` is drawn at random: "scenes".
void addSeedOption(CommandLine &line, const QString &what);
std::uint64_t chosenSeed(const CommandLine &line);

/// Adds --tolerance: the arithmetic in which a right program may compute.
void addToleranceOption(CommandLine &line);
Arithmetic chosenTolerance(const CommandLine &line);
/// Adds --leeway, too: what a right program may draw otherwise.
void addMarginOptions(CommandLine &line);
Margin chosenMargin(const CommandLine &line);

/// Adds --force EFFECT=on|off, which may be repeated.
void addForceOption(CommandLine &line);

/// What the options switch by hand.
EffectForcing chosenForcing(const CommandLine &line);

/// --input, --time and --memory: how a student's program is run.
void addProgramOptions(CommandLine &line);
/// Refuses these options where no side is a program.
void refuseProgramOptions(const CommandLine &line);
/// The terms from these options, with the default tolerance.
TrialTerms chosenTerms(const CommandLine &line);

/// What a program that ran without a sandbox could do, to be printed or added to a report wherever
/// a program was run. Nothing where there is a sandbox.
QStringList confinementLines();
void addConfinement(QJsonObject &report);

/// The positional argument that names a scene.
Positional scenePositional();
/// The positional argument that names one or more scenes.
Positional scenesPositional();

/// Adds --method, --arithmetic, --fill-rule, --rounding and --variant, which override the scene's
/// settings, and --force.
void addSettingOptions(CommandLine &line);

/// Why the run's method cannot draw its scene; none where it can.
std::optional<InputError> refusalOf(const SceneRun &run, const QString &path);

/// Reads a scene from the text of the file at `path`; its references are relative to that file.
SceneReading sceneIn(const QByteArray &text, const QString &path);

/// Reads the scene of a file ("-" is stdin) as it is. Snapped vertices are reported on stderr.
SceneReading readSceneAt(const QString &path);

/// The scene under the options' settings, whether or not its method can draw it then; errors name
/// the path. Settings in neither the options nor the scene are the method's own.
Scene underOptions(const CommandLine &line, SceneReading reading, const QString &path);

/// Reads the scene of a file ("-" is stdin) under the options' settings, with its run. Snapped
/// vertices are reported on stderr.
SceneRun readScene(const CommandLine &line, const QString &path);

/// Like readScene(), but accepts a scene that its method cannot draw: for commands that choose
/// another method.
Scene readSceneForAnyMethod(const CommandLine &line, const QString &path);

/// A scene with its name on the command line; none where it could not be read, which was reported.
struct NamedScene {
    QString path;
    std::optional<SceneRun> run;
};
using SceneReader = SceneRun (*)(const CommandLine &line, const QString &path);
/// Reads every scene that the command line names. All are read before anything is written, since an
/// output may be a file that one of them refers to.
std::vector<NamedScene> readScenes(const CommandLine &line, SceneReader read);

/// Refuses a scene that nobody's work can be judged by: its method draws nothing of it.
void refuseToJudgeBy(const Scene &scene, const QString &path);

QStringList methodIds();

/// The option's choice, or an error that lists the choices; `unset` is the default.
const Method *chosenMethod(const CommandLine &line, const QString &unset);
Arithmetic chosenArithmetic(const CommandLine &line, Arithmetic unset);
FillRule chosenFillRule(const CommandLine &line, FillRule unset);

/// Makes a scene's run, and traces it, and shows how far it is.
SceneRun runWithProgress(const Scene &scene);
std::shared_ptr<const TracedScene> tracedWithProgress(SceneRun run);

/// What --triangle can name: a run's primitives, counted from 0.
WholeRange primitivesOf(const ScanTrace &trace);

/// Reports on stderr what a method does not draw, so that an empty picture is explained: the first
/// five a line each, the rest as a count. `drawnBy` says which scene and method are meant:
/// "scene.json, polygon-fan".
void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected);

/// Reads "method[:arithmetic[:fill-rule[:variant…]]]" or "truth[:fill-rule]". What is left out
/// comes from the scene, or is the method's first choice where it lacks the scene's. The error
/// names the place ("--methods") and the wrong word.
Contender contenderNamed(const QString &place, const QString &entry, const ScanSettings &ofScene);

/// Reads two to four contenders, separated by commas, from the option --methods.
std::vector<Contender> contendersNamed(const QString &list, const ScanSettings &ofScene);

/// The command-line words that name the picture sources, and the sources they name.
struct Sides {
    std::vector<PictureSource> sources;
    Scene conventions; ///< without primitives

    bool hasProgram() const; ///< whether a source is somebody else's program
};

/// The kinds, corners and colours of a scene's primitives, a line each.
QStringList primitiveLines(const Scene &scene);
/// What could not be drawn, by which source and why.
QString undrawnText(const UndrawnScene &undrawn);
QJsonObject undrawnJson(const UndrawnScene &undrawn);

/// Help text: what a word that names a side may be.
QString sideMeaning();
/// Reads the sides from the first arguments; `places` are their names, for errors. Programs run as
/// the options of addProgramOptions() say.
Sides sidesOf(const CommandLine &line, const QStringList &places);

} // namespace pixelplumb::cli
