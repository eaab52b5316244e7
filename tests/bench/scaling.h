// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"
#include "machinereport.h"
#include "race.h"

namespace pixelplumb::bench {

/// One size of a series in which only the number of triangles, or only the frame, grows.
struct ScalingPoint {
    FrameSize size;
    std::size_t triangles = 0;
    int area = 0; ///< px per triangle
};

struct ScalingResult {
    ScalingPoint point;
    double pixelsPerTriangle = 0;
    std::vector<Result> results;
    /// The reference's own memory while it draws, beyond scene and frame, in bytes per triangle;
    /// none if the system does not report it.
    std::optional<double> workingBytes;
    QString skipped; ///< why nothing was measured; empty if something was
};

/// 10,000 to 10,000,000 triangles, then frames of 64² to 16384². Time per triangle and time per
/// pixel must stay flat except for steps where a cache ends.
std::vector<ScalingPoint> scalingPoints(Extent extent);

/// Measures one size. Frame and scene take up to a gigabyte each; `skipped` says if the machine has
/// too little memory.
ScalingResult measureScaling(const ScalingPoint &point, const std::vector<Contender *> &contenders,
                             const QString &referenceId, const RaceOptions &options,
                             const std::function<void(const QString &)> &progress);

QString markdown(const MachineConditions &machine, const std::vector<ScalingResult> &series);

} // namespace pixelplumb::bench
