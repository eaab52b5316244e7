// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/triangle.h"
#include "core/number/jobprogress.h"
#include "core/scan/scansettings.h"

#include <optional>
#include <span>

namespace pixelplumb {

/// How many pixels the column scan writes for the triangles (sample coordinates) under one of its
/// fill rules, in exact arithmetic: a pixel counts once for each triangle that covers it. Nothing
/// if the listener ended it.
std::optional<std::uint64_t> countWrites(std::span<const Triangle> triangles, FillRule rule,
                                         const FrameSpec &spec, const ProgressListener &listener);

} // namespace pixelplumb
