// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "app/cli/wholenumber.h"
#include "core/export/traceexport.h"

namespace pixelplumb::cli {

/// --triangle, --x and --y, which choose rows of a trace's table.
void addRowOptions(CommandLine &line);

/// What --triangle can name: a run's primitives, counted from 0.
WholeRange primitivesOf(const ScanTrace &trace);

/// The chosen rows, or an error where an option names what the run or the table lacks.
Result<RowChoice> chosenRows(const CommandLine &line, const TracedScene &traced, TraceLevel level);

} // namespace pixelplumb::cli
