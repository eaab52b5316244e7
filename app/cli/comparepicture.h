// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"

#include <QImage>

namespace pixelplumb::cli {

/// The first contender's picture, faint and grey. Pixels on which not all agree have the colour of
/// the reason (Okabe and Ito's palette): orange a tie rule, grey an undrawn kind, yellow rounding,
/// sky blue drift, vermilion precision, purple the method, black not recorded.
QImage pictureOf(const Contest &contest);

} // namespace pixelplumb::cli
