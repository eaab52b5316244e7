// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/grade/trial.h"

#include <QJsonObject>

namespace pixelplumb::cli {

/// --input, --time and --memory: how a student's program is run.
void addProgramOptions(CommandLine &line);
/// The error where one of these options is given but no side is a program; none where that is fine.
std::optional<InputError> refusalWithoutProgram(const CommandLine &line);
/// The terms from these options, with the default tolerance.
Result<TrialTerms> chosenTerms(const CommandLine &line);

/// What a program that ran without a sandbox could do, to be printed or added to a report wherever
/// a program was run. Nothing where there is a sandbox.
QStringList confinementLines();
void addConfinement(QJsonObject &report);

} // namespace pixelplumb::cli
