// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/labcontender.h"
#include "core/lab/judging/labfigures.h"
#include "core/lab/judging/pixelwindow.h"

namespace pixelplumb {

/// Checks what must not change a picture: the order in which the vertices are given, and moving
/// triangle and frame together by (5003, 3001) px. Adds one triangle to the two shares.
void addInvariance(const LabContender &contender, const ScanSettings &settings,
                   const Triangle &triangle, const FrameView &frame, AccuracyFigures &figures);

/// Pixels that appear or disappear from picture to picture of a motion.
struct Toggles {
    std::int64_t drawn = 0;
    std::int64_t ofTruth = 0;
};
Toggles togglesOf(const LabContender &contender, const ScanSettings &settings,
                  const std::vector<Triangle> &motion, const FrameView &frame);

} // namespace pixelplumb
