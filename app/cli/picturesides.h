// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/grade/counterexample.h"

#include <QJsonObject>

namespace pixelplumb::cli {

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
