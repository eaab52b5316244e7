// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/rejectedprimitives.h"

namespace pixelplumb::cli {

/// Says on stderr what a method does not draw, so that nobody wonders at an empty picture: the
/// first five a line each, the others by their number. `drawnBy` tells whose words they are:
/// "scene.json, polygon-fan".
void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected);

} // namespace pixelplumb::cli
