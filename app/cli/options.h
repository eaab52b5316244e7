// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/geometry/effect.h"
#include "core/grade/trial.h"
#include "core/scan/scansettings.h"

#include <QJsonObject>

#include <limits>

namespace pixelplumb::cli {

struct WholeRange {
    std::int64_t first = 0;
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
    QString outside = QStringLiteral("out of range"); ///< "5 is out of range"
};

/// Reads the word as a whole number in the range; the error names the place ("--limit", "X"), the
/// word and the range.
Result<std::int64_t> wholeNumber(const QString &place, const QString &word,
                                 const WholeRange &range);

/// Reads an option's number; none where it is not set and has no default.
Result<std::optional<std::int64_t>> wholeNumberOf(const CommandLine &line, const QString &option,
                                                  const WholeRange &range);

/// Adds --seed, 1 by default; `what` is drawn at random: "scenes".
void addSeedOption(CommandLine &line, const QString &what);
Result<std::uint64_t> chosenSeed(const CommandLine &line);

/// Adds --tolerance: the arithmetic in which a right program may compute.
void addToleranceOption(CommandLine &line);
/// Float32, float64 or exact.
Result<Arithmetic> chosenTolerance(const CommandLine &line);

/// Adds --force EFFECT=on|off, which may be repeated.
void addForceOption(CommandLine &line);

/// What the options switch by hand, or the error in one of them.
Result<EffectForcing> chosenForcing(const CommandLine &line);

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
