// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"

#include <QtGui>

#include <optional>

namespace pixelplumb {

/// What the colours of the agreement map mean, with the number of pixels of each.
QString agreementLegend(const AgreementMap &agreement, const QPalette &palette);

/// How many pixels a contender writes, and how many differ from the truth: "984 pixels: 0 missing
/// …"; with the tally of an earlier position, up to there: "412 of 984 pixels so far: …".
QString resultText(const ContenderRun &run, const ContenderTally &tally);
/// resultText() for little room: "984: correct", "984: 2 missing, 1 extra".
QString shortResultText(const ContenderRun &run, const ContenderTally &tally);

/// How far the contenders agree on what no picture shows, a line for each pair of contenders that
/// carries it; empty where none does.
QString carriedText(const Contest &contest);

/// How many contenders agree on a pixel, and why the others do not; without a pixel, how many
/// pixels differ.
QString pixelText(const Contest &contest, const std::optional<QPoint> &picked);

} // namespace pixelplumb
