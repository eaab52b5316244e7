// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/options.h"
#include "core/methods/method.h"
#include "core/runs/rejectedprimitives.h"
#include "core/scene/scenefile.h"
#include "core/trace/scantrace.h"

namespace pixelplumb::cli {

/// The positional argument that names a scene.
Positional scenePositional();
/// The positional argument that names one or more scenes.
Positional scenesPositional();

/// Adds --method, --arithmetic, --fill-rule, --rounding and --variant, which override the scene's
/// settings, and --force.
void addSettingOptions(CommandLine &line);

/// Why the scene's method cannot draw it; none where it can.
std::optional<InputError> refusalOf(const Scene &scene, const QString &path);

/// Reads a scene from the text of the file at `path`; its references are relative to that file.
Result<SceneReading> sceneIn(const QByteArray &text, const QString &path);

/// Reads the scene of a file ("-" is stdin) as it is. Snapped vertices are reported on stderr.
Result<SceneReading> readSceneAt(const QString &path);

/// The scene under the options' settings, whether or not its method can draw it then; errors name
/// the path. Settings in neither the options nor the scene are the method's own.
Result<Scene> underOptions(const CommandLine &line, SceneReading reading, const QString &path);

/// Reads the scene of a file ("-" is stdin) under the options' settings. Snapped vertices are
/// reported on stderr.
Result<Scene> readScene(const CommandLine &line, const QString &path);

/// Like readScene(), but accepts a scene that its method cannot draw: for commands that choose
/// another method.
Result<Scene> readSceneForAnyMethod(const CommandLine &line, const QString &path);

/// A scene with its name on the command line; none where it could not be read, which was reported.
struct NamedScene {
    QString path;
    std::optional<Scene> scene;
};
using SceneReader = Result<Scene> (*)(const CommandLine &line, const QString &path);
/// Reads every scene that the command line names. All are read before anything is written, since an
/// output may be a file that one of them refers to.
std::vector<NamedScene> readScenes(const CommandLine &line, SceneReader read);

/// Why a scene cannot be used to judge anybody's work: its method draws nothing of it.
std::optional<InputError> refusalToJudge(const Scene &scene, const QString &path);

/// The option's choice, or an error that lists the choices; `unset` is the default.
Result<const Method *> chosenMethod(const CommandLine &line, const QString &unset);
Result<Arithmetic> chosenArithmetic(const CommandLine &line, Arithmetic unset);
Result<FillRule> chosenFillRule(const CommandLine &line, FillRule unset);

/// What --triangle can name: a run's primitives, counted from 0.
WholeRange primitivesOf(const ScanTrace &trace);

/// Reports on stderr what a method does not draw, so that an empty picture is explained: the first
/// five a line each, the rest as a count. `drawnBy` says which scene and method are meant:
/// "scene.json, polygon-fan".
void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected);

} // namespace pixelplumb::cli
