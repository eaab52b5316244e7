// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lineup.h"
#include "machinereport.h"
#include "race.h"

namespace pixelplumb::bench {

/// One size in a series in which only the number of triangles, or only the frame, grows.
struct ScalingPoint {
    FrameSize size;
    std::size_t triangles = 0;
    int area = 0; ///< px a triangle
};

struct ScalingResult {
    ScalingPoint point;
    double pixelsPerTriangle = 0;
    std::vector<Result> results;
    /// What the reference takes for itself while it draws, beyond scene and frame, in bytes a
    /// triangle; none where the system does not tell.
    std::optional<double> workingBytes;
    QString skipped; ///< why nothing was measured; empty when something was
};

/// 10,000 to 10,000,000 triangles, then frames of 64² to 16384². Time a triangle and time a pixel
/// have to stay flat but for steps where a cache ends.
std::vector<ScalingPoint> scalingPoints(Extent extent);

/// Frame and scene take up to a gigabyte each; where the machine has too little, it says so.
ScalingResult measureScaling(const ScalingPoint &point, const std::vector<Contender *> &contenders,
                             const QString &referenceId, const RaceOptions &options,
                             const std::function<void(const QString &)> &progress);

QString markdown(const MachineConditions &machine, const std::vector<ScalingResult> &series);
QByteArray json(const MachineConditions &machine, const std::vector<ScalingResult> &series);

} // namespace pixelplumb::bench
