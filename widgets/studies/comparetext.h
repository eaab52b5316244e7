// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "core/runs/ahead.h"

#include <QPalette>
#include <QPoint>
#include <QString>

#include <optional>

namespace pixelplumb {

/// What the colours of the agreement map mean, and how many pixels have each, unless some of them
/// are ahead and hidden.
QString agreementLegend(const AgreementMap &agreement, const QPalette &palette, Ahead ahead);

/// How many pixels a contender writes, and how many are not the truth's: "984 pixels: 0 missing …".
QString resultText(const ContenderRun &run);
/// The same with the signs that mark such pixels, where there is little room: "984 px: 0 ? …".
QString resultInSigns(const ContenderRun &run);

/// How far the contenders agree on what no picture shows, a line for each pair that carries it;
/// empty where none does.
QString carriedText(const Contest &contest);

/// How many agree on a pixel, and why the others do not; without a pixel, how many differ. Where
/// what is ahead is hidden, of a pixel that is decided, and nothing of others.
QString pixelText(const Contest &contest, const std::optional<QPoint> &picked, Ahead ahead);

} // namespace pixelplumb
