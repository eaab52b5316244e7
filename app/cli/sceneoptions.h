// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/methods/method.h"
#include "core/scene/scenefile.h"

namespace pixelplumb::cli {

/// The positional argument that names a scene.
Positional scenePositional();
/// The same of one or more.
Positional scenesPositional();

/// --method, --arithmetic, --fill-rule, --rounding and --variant, which take the place of what the
/// scene says, and --force.
void addSettingOptions(CommandLine &line);

/// Why the scene's method cannot draw it; none where it can.
std::optional<InputError> refusalOf(const Scene &scene, const QString &path);

/// The scene that a text read from `path` is; what it refers to lies beside that.
Result<SceneReading> sceneIn(const QByteArray &text, const QString &path);

/// The scene of a file ("-" is stdin) as it is. Vertices that had to be snapped are reported on
/// stderr.
Result<SceneReading> readSceneAt(const QString &path);

/// A scene under the options' settings, whether or not its method can draw it so; errors name the
/// path. Settings that neither names are as the method has them.
Result<Scene> underOptions(const CommandLine &line, SceneReading reading, const QString &path);

/// The scene of a file ("-" is stdin), under the options' settings. Vertices that had to be snapped
/// are reported on stderr.
Result<Scene> readScene(const CommandLine &line, const QString &path);

/// The same, whether or not the scene's method can draw it so: for who chooses another.
Result<Scene> readSceneForAnyMethod(const CommandLine &line, const QString &path);

/// A scene by its name on the command line; none where it could not be read, which is said then.
struct NamedScene {
    QString path;
    std::optional<Scene> scene;
};
using SceneReader = Result<Scene> (*)(const CommandLine &line, const QString &path);
/// Every scene that the command line names: all are read before anything is written, which may be
/// what one of them refers to.
std::vector<NamedScene> readScenes(const CommandLine &line, SceneReader read);

/// Why nobody's work can be judged by a scene: its method draws nothing of it.
std::optional<InputError> refusalToJudge(const Scene &scene, const QString &path);

/// What an option chooses, or an error that lists the choices; unset keeps the default.
Result<const Method *> chosenMethod(const CommandLine &line, const QString &unset);
Result<Arithmetic> chosenArithmetic(const CommandLine &line, Arithmetic unset);
Result<FillRule> chosenFillRule(const CommandLine &line, FillRule unset);

} // namespace pixelplumb::cli
