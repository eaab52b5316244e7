// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"

#include <QString>

#include <vector>

namespace pixelplumb {

struct Method;
struct ScanSettings;
struct TracedScene;

// What the message bar says of a scene or a run that is not what a person expects.

/// Displacements of the coordinates that were not on the lattice: an error of the input, told once.
QString snapNote(const SnapReports &snaps);

/// What the kernel drew nothing of, with its reason for the first; empty where there is no such
/// primitive. Those that lie outside the frame, where everybody sees them lie, and a scene of
/// another method's kinds (see foreignSceneHint()) are not counted.
QString rejectionNote(const TracedScene &traced);

/// Which of the settings that were asked for the method does not keep, and what it draws by
/// instead; empty where it keeps them.
QString adaptationNote(const Method &method, const ScanSettings &asked);

/// The core's words about methods, as the window has them: titles in place of ids.
QString withTitles(const QString &text);
/// "Column scan draws no circles.": an objection (objectionTo) with who has it.
QString objectionNote(const Method &method, const QString &objection);

QString cutRunNote(const TracedScene &traced); ///< its recording ended at a limit
QString cancelledRunNote();

} // namespace pixelplumb
