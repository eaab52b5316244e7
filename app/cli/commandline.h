// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/console.h"
#include "core/export/rowwriter.h"
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

#include <QCommandLineParser>
#include <QJsonObject>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace pixelplumb::cli {

/// A row of the table of commands.
struct Command {
    QString name; ///< "render"
    QString summary; ///< one line
    ExitCode (*run)(const Command &command, const QStringList &arguments);
};

/// A word that follows the command.
struct Positional {
    enum class Presence {
        Required,
        Optional,
        Several, ///< at least one
        AnyNumber, ///< or none
        Command, ///< a program and its arguments, which may be empty
    };

    QString name; ///< "SCENE"
    QString meaning;
    /// All but required ones stand last.
    Presence presence = Presence::Required;
};

/// The words after a command: options, and the positional arguments that the command names. What
/// is wrong with them is told with the word in question.
class CommandLine {
public:
    CommandLine(const Command &command, std::vector<Positional> positionals);

    void addOption(const QCommandLineOption &option); ///< may be given once
    void addRepeatedOption(const QCommandLineOption &option); ///< may be repeated
    void addJsonOption();
    /// Ends the command where help was asked for, or the words are wrong.
    void parse(const QStringList &arguments);

    bool asksForJson() const { return isSet(u"json"_s); }
    bool isSet(const QString &option) const { return m_parser.isSet(option); }
    /// Negative numbers are values, not options.
    QString value(const QString &option) const;
    /// Every value of a repeated option.
    QStringList values(const QString &option) const { return m_parser.values(option); }
    /// The positional argument at a place, empty where an optional one is left out; negative
    /// numbers are arguments, not options.
    QString argument(qsizetype index) const;
    QStringList arguments() const;

    const QString &command() const { return m_name; }

private:
    QString unknownOption() const;
    void refuseRepeatedOption() const; ///< of those that may be given once
    void refuseEmptyOption() const; ///< an option whose value is empty
    void printHelp() const;

    QString m_name;
    QString m_summary;
    std::vector<Positional> m_positionals;
    QStringList m_optionNames;
    QList<QCommandLineOption> m_options;
    std::vector<QStringList> m_onceOnly; ///< the names of each option that may stand once
    QCommandLineParser m_parser;
};

/// Every command, in the order in which help lists them.
const std::vector<Command> &commands();

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

/// Which of the names the option gives; none where it is not set. Another word is refused with the
/// names; `what` it should have named: "budget".
std::optional<std::size_t> chosenName(const CommandLine &line, const QString &option,
                                      const QStringList &names, const QString &what);

/// The choice that an option names by its nameOf(), `unset` where the option is not set.
template <class Choice, std::size_t Count>
Choice chosen(const CommandLine &line, const QString &option,
              const std::array<Choice, Count> &choices, Choice unset,
              const QString &what = u"name"_s)
{
    const auto index = chosenName(line, option, namesOf(choices), what);
    return index ? choices[*index] : unset;
}

/// Which of text, csv and json --format names.
TableFormat chosenTableFormat(const CommandLine &line, TableFormat unset);

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
