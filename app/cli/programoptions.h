// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/grade/trial.h"

#include <QJsonObject>

namespace pixelplumb::cli {

/// --input, --time and --memory: how a student's program is run.
void addProgramOptions(CommandLine &line);
/// What is wrong where one of them is given and nothing is a program; none where none is.
std::optional<InputError> refusalWithoutProgram(const CommandLine &line);
/// What they say, with the tolerance that is taken if none is named.
Result<TrialTerms> chosenTerms(const CommandLine &line);

/// To be printed, or to be added to a report, wherever a program was run: what it could do, if it
/// ran in no sandbox. Nothing where there is one.
QStringList confinementLines();
void addConfinement(QJsonObject &report);

} // namespace pixelplumb::cli
