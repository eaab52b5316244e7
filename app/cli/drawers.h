// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/grade/counterexample.h"
#include "core/runs/contender.h"
#include "core/scene/result.h"

#include <QJsonObject>

namespace pixelplumb::cli {

/// Reads "method[:arithmetic[:fill-rule[:variant…]]]" or "truth[:fill-rule]". What is left out
/// comes from the scene, or is the method's first choice where it lacks the scene's. The error
/// names the place ("--methods") and the wrong word.
Result<Contender> contenderNamed(const QString &place, const QString &entry,
                                 const ScanSettings &ofScene);

/// Reads two to four contenders, separated by commas, from the option --methods.
Result<std::vector<Contender>> contendersNamed(const QString &list, const ScanSettings &ofScene);

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
Result<Sides> sidesOf(const CommandLine &line, const QStringList &places);

} // namespace pixelplumb::cli
