// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"

#include <QImage>

namespace pixelplumb::cli {

/// The first contender's picture, faint and without colour, with the pixels on which not all agree
/// in the colour of the reason (Okabe and Ito's): orange a tie rule, grey an undrawn kind, yellow
/// rounding, sky blue drift, vermilion precision, purple the method, black not recorded.
QImage pictureOf(const Contest &contest);

} // namespace pixelplumb::cli
