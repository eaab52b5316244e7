// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/rejectedprimitives.h"

namespace pixelplumb::cli {

/// Reports on stderr what a method does not draw, so that an empty picture is explained: the first
/// five a line each, the rest as a count. `drawnBy` says which scene and method are meant:
/// "scene.json, polygon-fan".
void reportRejections(const QString &drawnBy, const std::vector<RejectedPrimitive> &rejected);

} // namespace pixelplumb::cli
